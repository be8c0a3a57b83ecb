package bumper;

import lejos.hardware.Button;
import lejos.hardware.motor.Motor;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3TouchSensor;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.robotics.RegulatedMotor;
import lejos.robotics.SampleProvider;
import lejos.robotics.subsumption.Arbitrator;
import lejos.robotics.subsumption.Behavior;

/** The textbook bumper car: suppressed-flag loops, static motors, and a start that waits for a key. */
public class BumperCar {
    static final RegulatedMotor LEFT = Motor.B;
    static final RegulatedMotor RIGHT = Motor.C;

    public static void main(String[] args) {
        System.out.println("Press any key");
        Button.waitForAnyPress();
        while (Button.readButtons() != 0) {
            Thread.yield();
        }
        LEFT.setSpeed(400);
        RIGHT.setSpeed(400);
        Behavior[] behaviors = { new DriveForward(), new DetectWall(), new Quit() };
        new Arbitrator(behaviors).go();
    }

    static class DriveForward implements Behavior {
        private boolean suppressed = false;

        public boolean takeControl() {
            return true;
        }

        public void suppress() {
            suppressed = true;
        }

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

    static class DetectWall implements Behavior {
        private final EV3TouchSensor touch = new EV3TouchSensor(SensorPort.S1);
        private final EV3UltrasonicSensor sonar = new EV3UltrasonicSensor(SensorPort.S4);
        private final SampleProvider pressed = touch.getMode("Touch");
        private final SampleProvider distance = sonar.getMode("Distance");
        private final float[] touchSample = new float[1];
        private final float[] distanceSample = new float[1];
        private boolean suppressed = false;

        public boolean takeControl() {
            pressed.fetchSample(touchSample, 0);
            distance.fetchSample(distanceSample, 0);
            return touchSample[0] == 1 || distanceSample[0] < 0.25f;
        }

        public void suppress() {
            suppressed = true;
        }

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

    /** Ends the program when any key is pressed, in the middle of being asked. */
    static class Quit implements Behavior {
        public boolean takeControl() {
            if (Button.readButtons() != 0) {
                LEFT.stop();
                RIGHT.stop();
                System.exit(0);
            }
            return false;
        }

        public void suppress() {
        }

        public void action() {
        }
    }
}
