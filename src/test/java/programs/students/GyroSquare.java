package programs.students;

import lejos.hardware.motor.Motor;
import lejos.hardware.motor.NXTRegulatedMotor;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3GyroSensor;
import lejos.robotics.SampleProvider;
import lejos.utility.Delay;

/** A square whose corners are measured by the gyro. */
public class GyroSquare {
    static final NXTRegulatedMotor LEFT = Motor.B;
    static final NXTRegulatedMotor RIGHT = Motor.C;
    static EV3GyroSensor gyro = new EV3GyroSensor(SensorPort.S2);
    static SampleProvider angleMode = gyro.getAngleMode();

    static float angle() {
        float[] s = new float[angleMode.sampleSize()];
        angleMode.fetchSample(s, 0);
        return s[0];
    }

    /** To the left until the gyro says so, slower and slower. */
    static void turnTo(float target) {
        float error = target - angle();
        while (Math.abs(error) > 1) {
            int speed = (int) Math.max(30, Math.min(200, Math.abs(error) * 4));
            LEFT.setSpeed(speed);
            RIGHT.setSpeed(speed);
            if (error > 0) {
                LEFT.backward();
                RIGHT.forward();
            } else {
                LEFT.forward();
                RIGHT.backward();
            }
            Delay.msDelay(10);
            error = target - angle();
        }
        LEFT.stop(true);
        RIGHT.stop();
    }

    static void straight(int degrees) {
        LEFT.setSpeed(250);
        RIGHT.setSpeed(250);
        LEFT.rotate(degrees, true);
        RIGHT.rotate(degrees, false);
        while (LEFT.isMoving()) {
            Thread.yield();
        }
    }

    public static void main(String[] args) {
        gyro.reset();
        for (int side = 1; side <= 4; side++) {
            straight(600);
            turnTo(side * 90);
            System.out.println("corner " + side + " at " + Math.round(angle() / 10) * 10);
        }
        gyro.close();
    }
}
