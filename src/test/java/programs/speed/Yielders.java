package programs.speed;

import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.robotics.SampleProvider;

/** Two threads that yield to each other all the time: one reads the distance, one drives by it. */
public class Yielders {
    private static volatile float metres = 1;

    /** Runs for ever. */
    public static void main(String[] args) {
        SampleProvider distance = new EV3UltrasonicSensor(SensorPort.S4).getDistanceMode();
        Thread eye = new Thread(() -> {
            float[] sample = new float[1];
            while (true) {
                distance.fetchSample(sample, 0);
                metres = sample[0];
                Thread.yield();
            }
        }, "eye");
        eye.setDaemon(true);
        eye.start();
        EV3LargeRegulatedMotor left = new EV3LargeRegulatedMotor(MotorPort.B);
        EV3LargeRegulatedMotor right = new EV3LargeRegulatedMotor(MotorPort.C);
        boolean free = false;
        left.forward();
        while (true) {
            if (metres > 0.3f != free) {
                free = !free;
                if (free) {
                    right.forward();
                } else {
                    right.backward();
                }
            }
            Thread.yield();
        }
    }
}
