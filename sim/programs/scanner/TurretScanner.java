package scanner;

import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.motor.EV3MediumRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.robotics.SampleProvider;
import lejos.utility.Delay;

/** Turns its head all round, prints how far it is to the walls, and drives into the direction with the most room. */
public class TurretScanner {
    private static final int STEP = 30;

    public static void main(String[] args) {
        EV3MediumRegulatedMotor head = new EV3MediumRegulatedMotor(MotorPort.A);
        SampleProvider distance = new EV3UltrasonicSensor(SensorPort.S4).getDistanceMode();
        float[] sample = new float[1];
        int best = 0;
        float farthest = 0;
        for (int angle = -180; angle < 180; angle += STEP) {
            head.rotateTo(angle);
            Delay.msDelay(100);
            distance.fetchSample(sample, 0);
            System.out.println(angle + " " + (Float.isInfinite(sample[0]) ? "none" : Math.round(sample[0] * 1000)));
            if (sample[0] > farthest && !Float.isInfinite(sample[0])) {
                farthest = sample[0];
                best = angle;
            }
        }
        head.rotateTo(0);
        System.out.println("best " + best);
        // The ultrasonic eye looks behind while the head looks ahead; the motor counts to the left.
        turnLeft(best > 0 ? best - 180 : best + 180);
    }

    private static void turnLeft(int degrees) {
        EV3LargeRegulatedMotor left = new EV3LargeRegulatedMotor(MotorPort.B);
        EV3LargeRegulatedMotor right = new EV3LargeRegulatedMotor(MotorPort.C);
        int wheel = Math.round(degrees * 120f / 56);
        left.rotate(-wheel, true);
        right.rotate(wheel);
        left.waitComplete();
        left.rotate(720, true);
        right.rotate(720);
        left.waitComplete();
    }
}
