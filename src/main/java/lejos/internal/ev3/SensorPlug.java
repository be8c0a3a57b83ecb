package lejos.internal.ev3;

import brickless.hardware.SensorSocket;
import java.util.Map;

/** Sentences about what is plugged into an input port and how to change it. */
final class SensorPlug {
    private static final Map<String, String> DEVICES = Map.of(
            "EV3TouchSensor", "ev3-touch", "EV3ColorSensor", "ev3-color", "EV3UltrasonicSensor", "ev3-ultrasonic",
            "EV3GyroSensor", "ev3-gyro", "EV3IRSensor", "ev3-infrared", "NXTTouchSensor", "nxt-touch",
            "NXTLightSensor", "nxt-light", "NXTSoundSensor", "nxt-sound", "NXTColorSensor", "nxt-color",
            "NXTUltrasonicSensor", "nxt-ultrasonic");

    private SensorPlug() {}

    static String describe(String port, SensorSocket socket, String user) {
        String plugged = socket.connected();
        String found = (plugged.equals("none") ? "nothing" : plugged) + " is plugged into " + port;
        String device = user == null ? null : DEVICES.get(user);
        if (device == null) {
            return found + (user == null ? "" : "; " + user + " has no virtual counterpart that answers there");
        }
        return found + "; " + user + " needs data-sensor=\"" + device + "\" with data-port=\"" + port
                + "\" in the robot file, or a robot fitted to the program (--robot auto)";
    }
}
