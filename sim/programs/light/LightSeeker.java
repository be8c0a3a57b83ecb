package light;

import java.util.Random;
import lejos.hardware.motor.Motor;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3ColorSensor;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.robotics.RegulatedMotor;
import lejos.robotics.SampleProvider;
import lejos.utility.Delay;

/**
 * Finds the brightest place: wanders from wall to wall until it gets brighter, then climbs as bacteria do (goes on while it gets brighter,
 * else tries another direction). A lamp that turns out to be weak is remembered, and only brighter places count from then on.
 */
public class LightSeeker {
    private static final RegulatedMotor LEFT = Motor.B;
    private static final RegulatedMotor RIGHT = Motor.C;
    private static final float BRIGHT = 0.54f;
    private static final float CLOSE = 0.25f;
    /** So much brighter than the best known place is worth a climb. */
    private static final float BRIGHTER = 0.05f;
    /** So many attempts without a new best mean that this is the top. */
    private static final int PATIENCE = 10;

    private final SampleProvider light = new EV3ColorSensor(SensorPort.S3).getAmbientMode();
    private final SampleProvider ahead = new EV3UltrasonicSensor(SensorPort.S4).getDistanceMode();
    private final Random random = new Random();

    public static void main(String[] args) {
        new LightSeeker().run();
    }

    private void run() {
        LEFT.setSpeed(400);
        RIGHT.setSpeed(400);
        float known = mean(light);
        while (known < BRIGHT) {
            wander(known + BRIGHTER);
            known = climb();
            System.out.println("lamp of " + Math.round(100 * known));
        }
        System.out.println("bright");
    }

    /** From wall to wall until it is bright enough. */
    private void wander(float enough) {
        while (mean(light) < enough) {
            LEFT.forward();
            RIGHT.forward();
            if (mean(ahead) < CLOSE) {
                turn(100 + random.nextInt(90));
            }
        }
        LEFT.stop(true);
        RIGHT.stop();
    }

    /** Goes where it gets brighter; returns how bright it is at the brightest place. */
    private float climb() {
        float last = mean(light);
        float best = last;
        for (int attempts = 0; attempts < PATIENCE && best < BRIGHT; attempts++) {
            travel(80);
            float now = mean(light);
            if (now > best) {
                best = now;
                attempts = 0;
            }
            if (now < last || mean(ahead) < CLOSE) {
                turn(110);
            }
            last = now;
        }
        return best;
    }

    private static float mean(SampleProvider sensor) {
        float[] sample = new float[sensor.sampleSize()];
        float sum = 0;
        for (int i = 0; i < 5; i++) {
            sensor.fetchSample(sample, 0);
            sum += Math.min(1, sample[0]);
            Delay.msDelay(5);
        }
        return sum / 5;
    }

    private static void travel(int millimetres) {
        move(millimetres * 360 / 176, millimetres * 360 / 176);
    }

    private static void turn(int degrees) {
        move(degrees * 120 / 56, -degrees * 120 / 56);
    }

    private static void move(int left, int right) {
        LEFT.stop(true);
        RIGHT.stop();
        LEFT.rotate(left, true);
        RIGHT.rotate(right);
        LEFT.waitComplete();
    }
}
