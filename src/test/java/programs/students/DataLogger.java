package programs.students;

import java.io.BufferedReader;
import java.io.BufferedWriter;
import java.io.File;
import java.io.FileReader;
import java.io.FileWriter;
import java.io.IOException;
import java.io.PrintWriter;
import java.util.StringTokenizer;
import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.robotics.RegulatedMotor;

/** Drives towards a wall, logs time, tacho and distance as text, and reads the log again. */
public class DataLogger {
    public static void main(String[] args) {
        File log = new File("student-log.csv");
        RegulatedMotor[] motors = {new EV3LargeRegulatedMotor(MotorPort.B), new EV3LargeRegulatedMotor(MotorPort.C)};
        try (EV3UltrasonicSensor eyes = new EV3UltrasonicSensor(SensorPort.S4)) {
            PrintWriter writer = new PrintWriter(new BufferedWriter(new FileWriter(log)));
            writer.println("ms,tacho,metres");
            motors[0].synchronizeWith(new RegulatedMotor[] {motors[1]});
            motors[0].startSynchronization();
            for (RegulatedMotor m : motors) {
                m.setSpeed(180);
                m.forward();
            }
            motors[0].endSynchronization();
            long start = System.nanoTime();
            float[] sample = new float[1];
            do {
                eyes.fetchSample(sample, 0);
                long ms = (System.nanoTime() - start) / 1000000L;
                writer.printf("%d,%d,%.3f%n", ms, motors[0].getTachoCount(), sample[0]);
                Thread.sleep(100);
            } while (sample[0] > 0.25f);
            for (RegulatedMotor m : motors) {
                m.stop(true);
            }
            writer.close();
            analyse(log);
        } catch (IOException e) {
            e.printStackTrace();
        } catch (InterruptedException e) {
            System.out.println("interrupted");
        } finally {
            log.delete();
        }
    }

    private static void analyse(File log) throws IOException {
        BufferedReader reader = new BufferedReader(new FileReader(log));
        String header = reader.readLine();
        int lines = 0;
        int firstTacho = 0, lastTacho = 0;
        double first = 0, last = 0;
        for (String line = reader.readLine(); line != null; line = reader.readLine()) {
            StringTokenizer parts = new StringTokenizer(line, ",");
            parts.nextToken();
            lastTacho = Integer.parseInt(parts.nextToken());
            last = Double.parseDouble(parts.nextToken());
            if (lines++ == 0) {
                first = last;
                firstTacho = lastTacho;
            }
        }
        reader.close();
        double metresPerTurn = (first - last) / (lastTacho - firstTacho) * 360;
        System.out.println(header);
        System.out.println("lines " + lines);
        System.out.printf("circumference %.2f%n", metresPerTurn);
    }
}
