package light;

import lejos.hardware.motor.Motor;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3ColorSensor;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.robotics.RegulatedMotor;
import lejos.robotics.SampleProvider;
import lejos.utility.Delay;

/** Finds the brightest place as bacteria do: goes on while it gets brighter, else turns and tries another direction. */
public class LightSeeker {
    private static final RegulatedMotor LEFT = Motor.B;
    private static final RegulatedMotor RIGHT = Motor.C;
    private static final float BRIGHT = 0.5f;
    private static final float CLOSE = 0.25f;
    /** So many attempts without a new best mean that this lamp is too weak. */
    private static final int PATIENCE = 12;

    public static void main(String[] args) {
        SampleProvider light = new EV3ColorSensor(SensorPort.S3).getAmbientMode();
        SampleProvider ahead = new EV3UltrasonicSensor(SensorPort.S4).getDistanceMode();
        LEFT.setSpeed(400);
        RIGHT.setSpeed(400);
        float last = mean(light);
        float best = last;
        int attempts = 0;
        while (last < BRIGHT) {
            if (mean(ahead) < CLOSE) {
                turn(130);
            }
            travel(100);
            float now = mean(light);
            attempts = now > best ? 0 : attempts + 1;
            best = Math.max(best, now);
            if (attempts > PATIENCE) {
                leave(ahead);
                now = mean(light);
                best = now;
                attempts = 0;
            } else if (now < last) {
                turn(110);
            }
            last = now;
        }
        System.out.println("bright");
    }

    /** A metre away from here, as far as walls let it. */
    private static void leave(SampleProvider ahead) {
        for (int i = 0; i < 10; i++) {
            if (mean(ahead) < CLOSE) {
                turn(70);
            }
            travel(100);
        }
    }

    private static float mean(SampleProvider sensor) {
        float[] sample = new float[sensor.sampleSize()];
        float sum = 0;
        for (int i = 0; i < 10; i++) {
            sensor.fetchSample(sample, 0);
            sum += Math.min(1, sample[0]);
            Delay.msDelay(10);
        }
        return sum / 10;
    }

    private static void travel(int millimetres) {
        move(millimetres * 360 / 176, millimetres * 360 / 176);
    }

    private static void turn(int degrees) {
        move(degrees * 120 / 56, -degrees * 120 / 56);
    }

    private static void move(int left, int right) {
        LEFT.rotate(left, true);
        RIGHT.rotate(right);
        LEFT.waitComplete();
    }
}
