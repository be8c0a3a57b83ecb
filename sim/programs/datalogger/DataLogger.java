package datalogger;

import java.io.File;
import java.io.FileReader;
import java.io.FileWriter;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.Reader;
import java.util.Properties;
import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.robotics.SampleProvider;
import lejos.utility.Delay;

/**
 * Drives towards a wall and writes what it measures to log.csv; settings.properties, if there is one, tells the speed.
 */
public class DataLogger {
    private static final File SETTINGS = new File("settings.properties");
    private static final File LOG = new File("log.csv");
    private static final float STOP_METRES = 0.2f;
    private static final int PERIOD_MILLIS = 100;

    public static void main(String[] args) throws IOException {
        EV3LargeRegulatedMotor left = new EV3LargeRegulatedMotor(MotorPort.B);
        EV3LargeRegulatedMotor right = new EV3LargeRegulatedMotor(MotorPort.C);
        EV3UltrasonicSensor eyes = new EV3UltrasonicSensor(SensorPort.S4);
        int speed = Integer.parseInt(settings().getProperty("speed", "180"));
        left.setSpeed(speed);
        right.setSpeed(speed);
        left.forward();
        right.forward();
        int lines = log(left, eyes.getDistanceMode());
        left.stop(true);
        right.stop();
        System.out.println(lines + " lines at " + speed + " degrees per second, " + LOG.length() + " bytes");
        eyes.close();
        left.close();
        right.close();
    }

    private static Properties settings() throws IOException {
        Properties settings = new Properties();
        if (SETTINGS.exists()) {
            Reader reader = new FileReader(SETTINGS);
            try {
                settings.load(reader);
            } finally {
                reader.close();
            }
        }
        return settings;
    }

    /** Returns the number of lines. */
    private static int log(EV3LargeRegulatedMotor motor, SampleProvider distance) throws IOException {
        PrintWriter log = new PrintWriter(new FileWriter(LOG));
        try {
            log.println("milliseconds,degrees,metres");
            long start = System.currentTimeMillis();
            float[] metres = new float[distance.sampleSize()];
            int lines = 0;
            do {
                distance.fetchSample(metres, 0);
                log.println((System.currentTimeMillis() - start) + "," + motor.getTachoCount() + "," + metres[0]);
                lines++;
                Delay.msDelay(PERIOD_MILLIS);
            } while (metres[0] > STOP_METRES);
            return lines;
        } finally {
            log.close();
        }
    }
}
