package sumo;

import lejos.hardware.motor.Motor;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3ColorSensor;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.robotics.RegulatedMotor;
import lejos.robotics.SampleProvider;

/** Charges at whatever is before it, looks round for it otherwise, and keeps away from the white rim. */
public class Wrestler {
    private static final RegulatedMotor LEFT = Motor.B;
    private static final RegulatedMotor RIGHT = Motor.C;
    private static final float WHITE = 0.4f;
    private static final float IN_SIGHT = 0.8f;

    public static void main(String[] args) {
        SampleProvider floor = new EV3ColorSensor(SensorPort.S3).getRedMode();
        SampleProvider ahead = new EV3UltrasonicSensor(SensorPort.S4).getDistanceMode();
        float[] sample = new float[2];
        while (true) {
            floor.fetchSample(sample, 0);
            ahead.fetchSample(sample, 1);
            if (sample[0] > WHITE) {
                speed(500);
                LEFT.rotate(-300, true);
                RIGHT.rotate(-300);
                LEFT.waitComplete();
                LEFT.rotate(300, true);
                RIGHT.rotate(-300);
                LEFT.waitComplete();
            } else if (sample[1] < IN_SIGHT) {
                speed(Math.round(LEFT.getMaxSpeed()));
                LEFT.forward();
                RIGHT.forward();
            } else {
                speed(200);
                LEFT.forward();
                RIGHT.backward();
            }
        }
    }

    private static void speed(int degreesPerSecond) {
        LEFT.setSpeed(degreesPerSecond);
        RIGHT.setSpeed(degreesPerSecond);
    }
}
