package programs.students;

import java.io.File;
import java.io.FileInputStream;
import java.io.FileNotFoundException;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.Properties;
import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.utility.PilotProps;

/** Keeps what it has learned in a properties file; the first start finds none. */
public class StoredSettings {
    private static final File FILE = new File("student-settings.properties");

    private final Properties properties = new Properties();

    private boolean load() throws IOException {
        try (InputStream in = new FileInputStream(FILE)) {
            properties.load(in);
            return true;
        } catch (FileNotFoundException e) {
            System.out.println("no settings yet");
            return false;
        }
    }

    private void save() throws IOException {
        try (OutputStream out = new FileOutputStream(FILE)) {
            properties.store(out, "what the robot knows");
        }
    }

    private int getInt(String key, int otherwise) {
        return Integer.parseInt(properties.getProperty(key, Integer.toString(otherwise)));
    }

    public static void main(String[] args) throws IOException {
        FILE.delete();
        StoredSettings first = new StoredSettings();
        first.load();
        int speed = first.getInt("speed", 250);
        EV3LargeRegulatedMotor motor = new EV3LargeRegulatedMotor(MotorPort.B);
        motor.setSpeed(speed);
        motor.rotate(360);
        first.properties.setProperty("speed", String.valueOf(speed + 50));
        first.properties.setProperty("degrees", String.valueOf(Math.round(motor.getTachoCount() / 10f) * 10));
        first.save();

        StoredSettings second = new StoredSettings();
        System.out.println("found " + second.load());
        System.out.println("speed " + second.getInt("speed", 0));
        System.out.println("degrees " + second.getInt("degrees", 0));
        System.out.println("folder " + FILE.getAbsoluteFile().getParent());
        FILE.delete();
        pilotProperties();
    }

    private static void pilotProperties() throws IOException {
        PilotProps pilot = new PilotProps();
        float wheel = Float.parseFloat(pilot.getProperty(PilotProps.KEY_WHEELDIAMETER, "4.0"));
        float track = Float.parseFloat(pilot.getProperty(PilotProps.KEY_TRACKWIDTH, "18.0"));
        boolean reverse = Boolean.parseBoolean(pilot.getProperty(PilotProps.KEY_REVERSE, "false"));
        System.out.println("pilot " + wheel + " " + track + " " + reverse);
    }
}
