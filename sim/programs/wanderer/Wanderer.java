package wanderer;

import lejos.hardware.Button;
import lejos.hardware.ev3.LocalEV3;
import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.robotics.SampleProvider;
import lejos.robotics.subsumption.Arbitrator;
import lejos.robotics.subsumption.Behavior;

/** Fire-and-return behaviours: an action starts the motors and returns at once; nothing loops on a suppressed flag. */
public class Wanderer {
    static final EV3LargeRegulatedMotor left = new EV3LargeRegulatedMotor(LocalEV3.get().getPort("B"));
    static final EV3LargeRegulatedMotor right = new EV3LargeRegulatedMotor(LocalEV3.get().getPort("C"));
    static final EV3UltrasonicSensor sonar = new EV3UltrasonicSensor(LocalEV3.get().getPort("S4"));

    public static void main(String[] args) {
        final SampleProvider distance = sonar.getDistanceMode();
        Behavior forward = new Behavior() {
            public boolean takeControl() {
                return true;
            }

            public void action() {
                left.setSpeed(300);
                right.setSpeed(300);
                left.forward();
                right.forward();
            }

            public void suppress() {
            }
        };
        Behavior turn = new Behavior() {
            public boolean takeControl() {
                float[] metres = new float[distance.sampleSize()];
                distance.fetchSample(metres, 0);
                return metres[0] < 0.3;
            }

            public void action() {
                left.setSpeed(200);
                right.setSpeed(200);
                left.forward();
                right.backward();
            }

            public void suppress() {
            }
        };
        Behavior escape = new Behavior() {
            public boolean takeControl() {
                return Button.ESCAPE.isDown();
            }

            public void action() {
                System.exit(0);
            }

            public void suppress() {
            }
        };
        new Arbitrator(new Behavior[] { forward, turn, escape }, false).go();
    }
}
