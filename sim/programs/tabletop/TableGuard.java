package tabletop;

import lejos.hardware.motor.Motor;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3ColorSensor;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.robotics.RegulatedMotor;
import lejos.robotics.SampleProvider;

/** Patrols a table for two minutes: where the floor is gone, it backs off and turns; before things on the table it turns, too. */
public class TableGuard {
    private static final RegulatedMotor LEFT = Motor.B;
    private static final RegulatedMotor RIGHT = Motor.C;
    /** Less light than this comes back only from beyond the edge. */
    private static final float NOTHING = 0.06f;
    private static final float CLOSE = 0.15f;

    public static void main(String[] args) {
        SampleProvider floor = new EV3ColorSensor(SensorPort.S3).getRedMode();
        SampleProvider ahead = new EV3UltrasonicSensor(SensorPort.S4).getDistanceMode();
        float[] sample = new float[2];
        int edges = 0;
        long start = System.currentTimeMillis();
        while (System.currentTimeMillis() < start + 120000) {
            floor.fetchSample(sample, 0);
            ahead.fetchSample(sample, 1);
            if (sample[0] < NOTHING) {
                edges++;
                move(-400, -400);
                turnRight();
            } else if (sample[1] < CLOSE) {
                turnRight();
            } else {
                forward();
            }
        }
        move(0, 0);
        System.out.println("edges: " + edges);
    }

    private static void forward() {
        LEFT.setSpeed(250);
        RIGHT.setSpeed(250);
        LEFT.forward();
        RIGHT.forward();
    }

    /** A quarter turn. */
    private static void turnRight() {
        move(193, -193);
    }

    private static void move(int left, int right) {
        LEFT.stop(true);
        RIGHT.stop();
        LEFT.rotate(left, true);
        RIGHT.rotate(right);
        LEFT.waitComplete();
    }
}
