package brickless.simulation;

import brickless.hardware.BrickHardware;
import brickless.hardware.KeySocket;
import brickless.hardware.LedSocket;
import brickless.hardware.MotorSocket;
import brickless.hardware.MoveRequest;
import brickless.hardware.PowerSocket;
import brickless.hardware.ProgramLog;
import brickless.hardware.ScreenSocket;
import brickless.hardware.SensorSocket;
import brickless.hardware.SpeakerSocket;
import java.util.List;

/** The sockets of one robot's brick, put together. */
record VirtualBrick(String name, List<? extends MotorSocket> motors, List<? extends SensorSocket> sensors, ScreenSocket screen, KeySocket keys,
        LedSocket leds, SpeakerSocket speaker, PowerSocket power, ProgramLog log) implements BrickHardware {
    VirtualBrick {
        motors = List.copyOf(motors);
        sensors = List.copyOf(sensors);
    }

    @Override public MotorSocket motor(int index) {
        return motors.get(index);
    }

    @Override public SensorSocket sensor(int index) {
        return sensors.get(index);
    }

    @Override public void moveTogether(int[] ports, MoveRequest[] requests) {
        for (int i = 0; i < ports.length; i++) {
            motors.get(ports[i]).regulation().move(requests[i]);
        }
    }
}
