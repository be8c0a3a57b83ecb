package obstacles;

import java.util.Random;
import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3GyroSensor;
import lejos.hardware.sensor.EV3TouchSensor;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.robotics.SampleProvider;

/**
 * Keeps to the direction it started in: what it sees or bumps into it goes round, to one side as long as there is room, then to the other, and
 * turns back into its old direction by the gyro.
 */
public class Steadfast {
    private static final int CRUISE = 450;
    private static final float CLOSE = 0.16f;
    private static final float GAIN = 8;
    /** Motor degrees: all the way to the next obstacle. */
    private static final int FAR = 100000;
    /** Least way aside. */
    private static final int STEP = 180;
    /** So many checks without a motor degree of progress mean that something holds the robot. */
    private static final int STUCK = 200;

    private final EV3LargeRegulatedMotor left = new EV3LargeRegulatedMotor(MotorPort.B);
    private final EV3LargeRegulatedMotor right = new EV3LargeRegulatedMotor(MotorPort.C);
    private final SampleProvider bumper = new EV3TouchSensor(SensorPort.S1).getTouchMode();
    private final SampleProvider gyro = new EV3GyroSensor(SensorPort.S2).getAngleMode();
    private final SampleProvider ahead = new EV3UltrasonicSensor(SensorPort.S4).getDistanceMode();
    private final Random random = new Random();
    private final float[] sample = new float[1];

    public static void main(String[] args) {
        new Steadfast().run();
    }

    private void run() {
        int side = 1;
        while (true) {
            forward(FAR);
            back();
            turnTo(side * 90);
            int step = STEP + random.nextInt(STEP);
            if (forward(step) < step / 2) {
                side = -side;
            }
            back();
            turnTo(0);
        }
    }

    /** Straight ahead until something is in the way, or for some motor degrees; returns how far it went. */
    private int forward(int degrees) {
        int start = left.getTachoCount();
        int last = start;
        float heading = read(gyro);
        int held = 0;
        while (last < start + degrees && read(bumper) == 0 && read(ahead) > CLOSE && held < STUCK) {
            int turn = Math.round(GAIN * (read(gyro) - heading));
            left.setSpeed(CRUISE + turn);
            right.setSpeed(CRUISE - turn);
            left.forward();
            right.forward();
            held = left.getTachoCount() == last ? held + 1 : 0;
            last = left.getTachoCount();
        }
        left.stop(true);
        right.stop();
        return last - start;
    }

    /** A little way back if something is close ahead. */
    private void back() {
        if (read(bumper) == 1 || read(ahead) < 1.5f * CLOSE) {
            move(-280, -280);
        }
    }

    /** Turns until the gyro, which counts to the left, shows an angle. */
    private void turnTo(int angle) {
        for (int attempt = 0; attempt < 2; attempt++) {
            int wheel = Math.round((angle - read(gyro)) * 120 / 56);
            move(-wheel, wheel);
        }
    }

    private float read(SampleProvider sensor) {
        sensor.fetchSample(sample, 0);
        return sample[0];
    }

    private void move(int leftDegrees, int rightDegrees) {
        left.setSpeed(CRUISE / 2);
        right.setSpeed(CRUISE / 2);
        left.rotate(leftDegrees, true);
        right.rotate(rightDegrees);
        left.waitComplete();
    }
}
