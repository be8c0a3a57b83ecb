package kit;

import lejos.hardware.Battery;
import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.utility.Delay;
import lejos.utility.Stopwatch;

/** A large motor without load: how long its moves take, and where they end. */
public final class Rotations {
    private static final EV3LargeRegulatedMotor MOTOR = new EV3LargeRegulatedMotor(MotorPort.A);

    private Rotations() {}

    public static void main(String[] args) {
        System.out.println("maxSpeed " + MOTOR.getMaxSpeed() / Battery.getVoltage());
        for (int speed : new int[] {90, 360, 720}) {
            rotate("at" + speed, speed, 360);
        }
        rotate("back", 360, -90);
        rotate("triangle", 360, 10);
        rotate("nothing", 360, 0);
        rotate("tooFast", 2000, 3600);
        drift();
        stopping();
        blending();
        latching();
    }

    private static void rotate(String name, int speed, int angle) {
        MOTOR.setSpeed(speed);
        int before = MOTOR.getTachoCount();
        Stopwatch watch = new Stopwatch();
        MOTOR.rotate(angle);
        System.out.println(name + " " + watch.elapsed() + " " + (MOTOR.getTachoCount() - before) + " "
                + MOTOR.isMoving());
    }

    private static void drift() {
        MOTOR.setSpeed(400);
        MOTOR.rotateTo(0);
        for (int i = 0; i < 30; i++) {
            MOTOR.rotate(7);
        }
        System.out.println("drift " + MOTOR.getTachoCount() + " " + MOTOR.getPosition() + " " + MOTOR.getLimitAngle());
    }

    private static void stopping() {
        MOTOR.setSpeed(360);
        MOTOR.forward();
        System.out.println("endless " + MOTOR.isMoving() + " " + MOTOR.getLimitAngle());
        Delay.msDelay(500);
        System.out.println("cruising " + MOTOR.getRotationSpeed());
        int before = MOTOR.getTachoCount();
        Stopwatch watch = new Stopwatch();
        MOTOR.stop();
        System.out.println("stop " + watch.elapsed() + " " + (MOTOR.getTachoCount() - before) + " "
                + MOTOR.getRotationSpeed());
        watch.reset();
        MOTOR.stop();
        MOTOR.flt();
        System.out.println("idleStop " + watch.elapsed());
    }

    /** A reversal ramps through zero without a stop: 120 ms from 360 to −360 deg/s. */
    private static void blending() {
        MOTOR.rotateTo(0);
        MOTOR.forward();
        Delay.msDelay(500);
        MOTOR.backward();
        Delay.msDelay(60);
        System.out.println("reversing " + MOTOR.getRotationSpeed() + " " + MOTOR.isMoving());
        Delay.msDelay(100);
        System.out.println("reversed " + MOTOR.getRotationSpeed());
        MOTOR.stop(true);
        System.out.println("stopping " + MOTOR.isMoving() + " " + MOTOR.getLimitAngle());
        MOTOR.waitComplete();
    }

    private static void latching() {
        MOTOR.forward();
        MOTOR.setSpeed(0);
        Delay.msDelay(400);
        System.out.println("latched " + MOTOR.isMoving());
        MOTOR.setSpeed(300);
        Delay.msDelay(200);
        System.out.println("stillLatched " + MOTOR.isMoving());
        MOTOR.forward();
        System.out.println("unlatched " + MOTOR.isMoving());
        MOTOR.flt(true);
    }
}
