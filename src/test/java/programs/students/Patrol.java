package programs.students;

import lejos.hardware.Button;
import lejos.hardware.Sound;
import lejos.hardware.motor.Motor;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3TouchSensor;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.robotics.RangeFinder;
import lejos.robotics.RangeFinderAdapter;
import lejos.robotics.chassis.Chassis;
import lejos.robotics.chassis.Wheel;
import lejos.robotics.chassis.WheeledChassis;
import lejos.robotics.navigation.MovePilot;
import lejos.robotics.subsumption.Arbitrator;
import lejos.robotics.subsumption.Behavior;

/** Patrols with behaviours that are inner classes of the program. */
public class Patrol {
    private final MovePilot pilot;
    private final EV3TouchSensor touch = new EV3TouchSensor(SensorPort.S1);
    private final RangeFinder eyes = new RangeFinderAdapter(new EV3UltrasonicSensor(SensorPort.S4).getDistanceMode());
    private final float[] pressed = new float[1];
    private int avoided, bumped;
    private Arbitrator arbitrator;

    Patrol() {
        Wheel left = WheeledChassis.modelWheel(Motor.B, 5.6).offset(6);
        Wheel right = WheeledChassis.modelWheel(Motor.C, 5.6).offset(-6);
        Chassis chassis = new WheeledChassis(new Wheel[] {left, right}, WheeledChassis.TYPE_DIFFERENTIAL);
        pilot = new MovePilot(chassis);
        pilot.setLinearSpeed(20);
        pilot.setAngularSpeed(120);
    }

    class Drive implements Behavior {
        private boolean suppressed;

        public boolean takeControl() {
            return true;
        }

        public void suppress() {
            suppressed = true;
        }

        public void action() {
            suppressed = false;
            pilot.forward();
            while (!suppressed && pilot.isMoving()) {
                Thread.yield();
            }
            pilot.stop();
        }
    }

    class Avoid implements Behavior {
        public boolean takeControl() {
            return eyes.getRange() < 25;
        }

        public void suppress() { }

        public void action() {
            avoided++;
            pilot.rotate(avoided % 2 == 0 ? 100 : -70);
        }
    }

    class Bump implements Behavior {
        public boolean takeControl() {
            touch.fetchSample(pressed, 0);
            return pressed[0] == 1;
        }

        public void suppress() { }

        public void action() {
            bumped++;
            Sound.playTone(300, 100);
            pilot.travel(-15);
            pilot.rotate(90);
        }
    }

    class Stop implements Behavior {
        public boolean takeControl() {
            return Button.ESCAPE.isDown();
        }

        public void suppress() { }

        public void action() {
            System.out.println("avoided " + (avoided > 0) + ", bumped " + bumped);
            arbitrator.stop();
        }
    }

    public static void main(String[] args) {
        Patrol p = new Patrol();
        Behavior[] behaviors = {p.new Drive(), p.new Avoid(), p.new Bump(), p.new Stop()};
        p.arbitrator = new Arbitrator(behaviors);
        p.arbitrator.go();
        System.out.println("end");
    }
}
