package lejos.robotics.filter;

import java.io.FileNotFoundException;
import java.util.Map;
import java.util.Properties;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Calibration data by name. On a brick they are files in {@code /home/root/sensorCalibration}; here they live as long
 * as the robot's program, so that runs cannot influence each other.
 */
final class CalibrationFiles {
    private static final Map<String, Properties> FILES = new ConcurrentHashMap<>();

    private CalibrationFiles() {}

    static Properties read(String name) throws FileNotFoundException {
        Properties kept = FILES.get(name);
        if (kept == null) {
            throw new FileNotFoundException("/home/root/sensorCalibration/" + name + ".cal");
        }
        return copy(kept);
    }

    static void write(String name, Properties properties) {
        FILES.put(name, copy(properties));
    }

    private static Properties copy(Properties properties) {
        Properties copy = new Properties();
        copy.putAll(properties);
        return copy;
    }
}
