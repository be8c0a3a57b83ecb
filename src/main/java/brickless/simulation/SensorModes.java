package brickless.simulation;

import brickless.device.RobotDevices;
import brickless.device.sensor.SensorPortDevice;
import brickless.trace.TraceEvent;

/**
 * Which modes the sensors of a robot are in, as it is worth writing down: changes, when a sample is taken; a program
 * that goes to and fro between samples writes nothing. A sensor that goes dark keeps its mode here. Used by one thread
 * at a time.
 */
final class SensorModes {
    private static final int PORTS = 4;

    /** Told what to write down. */
    interface Listener {
        void changed(long timeNanos, TraceEvent.ModeEvent mode);
    }

    private final Listener listener;
    private final TraceEvent.ModeEvent[] last = new TraceEvent.ModeEvent[PORTS];

    SensorModes(Listener listener) {
        this.listener = listener;
    }

    void note(long nowNanos, RobotDevices devices) {
        for (int port = 0; port < PORTS; port++) {
            SensorPortDevice device = devices.sensor(port);
            String mode = device.modeName();
            if (!mode.isEmpty() && (last[port] == null || !last[port].mode().equals(mode))) {
                last[port] = new TraceEvent.ModeEvent(port + 1, device.connected(), mode);
                listener.changed(nowNanos, last[port]);
            }
        }
    }
}
