package lejos.internal.ev3;

import brickless.hardware.BrickAccess;
import brickless.hardware.BrickHardware;
import brickless.hardware.SensorSocket;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** Sentences about what is plugged into an input port, what the program wants there, and how to change it. */
final class SensorPlug {
    private static final String NOTHING = "none";
    private static final int PORTS = 4;
    private static final Map<String, String> DEVICES = Map.of(
            "EV3TouchSensor", "ev3-touch", "EV3ColorSensor", "ev3-color", "EV3UltrasonicSensor", "ev3-ultrasonic",
            "EV3GyroSensor", "ev3-gyro", "EV3IRSensor", "ev3-infrared", "NXTTouchSensor", "nxt-touch",
            "NXTLightSensor", "nxt-light", "NXTSoundSensor", "nxt-sound", "NXTColorSensor", "nxt-color",
            "NXTUltrasonicSensor", "nxt-ultrasonic");
    private static final Map<String, String> KINDS = Map.of(
            "UARTSensor", "a serial sensor (ev3-color, ev3-gyro, ev3-infrared, ev3-ultrasonic)",
            "I2CSensor", "an I2C sensor with that address (nxt-ultrasonic has 0x02)");

    private SensorPlug() {}

    /**
     * Describes a port.
     *
     * @param lejosClass class of leJOS that uses the port, null if unknown
     * @param user the program's own class, or the same
     */
    static String describe(String port, SensorSocket socket, String lejosClass, String user) {
        String plugged = socket.connected();
        String found = plugged.equals(NOTHING) ? "nothing is plugged into " + port : port + " has " + plugged
                + " plugged in";
        if (lejosClass == null) {
            return found;
        }
        String device = DEVICES.get(lejosClass);
        if (device == null) {
            return found + ", but the program's " + user + " wants "
                    + KINDS.getOrDefault(lejosClass, "a device that cannot be simulated yet") + " there";
        }
        return found + ", but the program wants " + user + " there: " + advice(port, plugged, device);
    }

    private static String advice(String port, String plugged, String device) {
        String draw = plugged.equals(NOTHING)
                ? "add a sensor with data-port=\"" + port + "\" data-sensor=\"" + device + "\" to the robot's SVG"
                : "put data-sensor=\"" + device + "\" there in the robot's SVG";
        List<String> elsewhere = portsWith(device);
        String move = elsewhere.isEmpty() ? ""
                : ", open it on " + String.join(" or ", elsewhere) + ", where the robot has its " + device;
        return draw + move + ", or use --robot auto";
    }

    private static List<String> portsWith(String device) {
        BrickHardware brick = BrickAccess.brick();
        List<String> ports = new ArrayList<>();
        for (int i = 0; i < PORTS; i++) {
            if (brick.sensor(i).connected().equals(device)) {
                ports.add("S" + (i + 1));
            }
        }
        return ports;
    }
}
