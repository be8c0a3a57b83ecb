package programs.robots;

import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3TouchSensor;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.robotics.SampleProvider;
import lejos.robotics.subsumption.Arbitrator;
import lejos.robotics.subsumption.Behavior;

/** An arbitrator with two behaviours, and two threads that poll a sensor each every 10 ms. */
public class TwoPollers {
    private static volatile float metres = Float.POSITIVE_INFINITY;
    private static volatile float bumper;

    /** Runs for ever. */
    public static void main(String[] args) {
        EV3LargeRegulatedMotor left = new EV3LargeRegulatedMotor(MotorPort.B);
        EV3LargeRegulatedMotor right = new EV3LargeRegulatedMotor(MotorPort.C);
        SampleProvider distance = new EV3UltrasonicSensor(SensorPort.S4).getDistanceMode();
        SampleProvider touch = new EV3TouchSensor(SensorPort.S1).getTouchMode();
        poll("ear", () -> metres = read(distance));
        poll("skin", () -> bumper = read(touch));
        new Arbitrator(new Behavior[] {new Drive(left, right), new Stop()}).go();
    }

    private static void poll(String name, Runnable action) {
        Thread thread = new Thread(() -> {
            while (true) {
                action.run();
                pause();
            }
        }, name);
        thread.setDaemon(true);
        thread.start();
    }

    private static void pause() {
        try {
            Thread.sleep(10);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private static float read(SampleProvider provider) {
        float[] sample = new float[1];
        provider.fetchSample(sample, 0);
        return sample[0];
    }

    private static class Drive implements Behavior {
        private final EV3LargeRegulatedMotor left;
        private final EV3LargeRegulatedMotor right;
        private volatile boolean suppressed;

        Drive(EV3LargeRegulatedMotor left, EV3LargeRegulatedMotor right) {
            this.left = left;
            this.right = right;
        }

        @Override
        public boolean takeControl() {
            return true;
        }

        @Override
        public void action() {
            suppressed = false;
            left.forward();
            right.forward();
            while (!suppressed) {
                Thread.yield();
            }
            left.stop(true);
            right.stop(true);
        }

        @Override
        public void suppress() {
            suppressed = true;
        }
    }

    private static class Stop implements Behavior {
        @Override
        public boolean takeControl() {
            return metres < 0.1f || bumper > 0.5f;
        }

        @Override
        public void action() {
            System.out.println("near");
        }

        @Override
        public void suppress() {
            System.out.println("suppressed");
        }
    }
}
