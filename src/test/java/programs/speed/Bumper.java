package programs.speed;

import lejos.hardware.motor.Motor;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3TouchSensor;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.robotics.RegulatedMotor;
import lejos.robotics.SampleProvider;
import lejos.robotics.subsumption.Arbitrator;
import lejos.robotics.subsumption.Behavior;

/**
 * The textbook bumper car, for ever: an arbitrator whose behaviours ask a touch and an ultrasonic sensor all the time.
 */
public class Bumper {
    static final RegulatedMotor LEFT = Motor.B;
    static final RegulatedMotor RIGHT = Motor.C;

    /** Runs for ever. */
    public static void main(String[] args) {
        LEFT.setSpeed(400);
        RIGHT.setSpeed(400);
        new Arbitrator(new Behavior[] {new Drive(), new Avoid()}).go();
    }

    private static class Drive implements Behavior {
        private volatile boolean suppressed;

        @Override
        public boolean takeControl() {
            return true;
        }

        @Override
        public void suppress() {
            suppressed = true;
        }

        @Override
        public void action() {
            suppressed = false;
            LEFT.forward();
            RIGHT.forward();
            while (!suppressed) {
                Thread.yield();
            }
            LEFT.stop(true);
            RIGHT.stop(true);
        }
    }

    private static class Avoid implements Behavior {
        private final SampleProvider touch = new EV3TouchSensor(SensorPort.S1).getTouchMode();
        private final SampleProvider distance = new EV3UltrasonicSensor(SensorPort.S4).getDistanceMode();
        private final float[] sample = new float[2];
        private volatile boolean suppressed;

        @Override
        public boolean takeControl() {
            touch.fetchSample(sample, 0);
            distance.fetchSample(sample, 1);
            return sample[0] == 1 || sample[1] < 0.25f;
        }

        @Override
        public void suppress() {
            suppressed = true;
        }

        @Override
        public void action() {
            suppressed = false;
            LEFT.rotate(-180, true);
            RIGHT.rotate(-360, true);
            while (RIGHT.isMoving() && !suppressed) {
                Thread.yield();
            }
            LEFT.stop();
            RIGHT.stop();
        }
    }
}
