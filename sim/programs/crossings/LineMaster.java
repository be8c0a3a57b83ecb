package crossings;

import lejos.hardware.Button;
import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3ColorSensor;
import lejos.robotics.SampleProvider;

/**
 * Follows the left edge of a line, so that it takes the leftmost way at every crossing. Where the line ends it looks whether it goes on
 * straight ahead behind a gap, and only if not turns round its end. In red light a blue mark is as dark as the line and a red one as
 * bright as the floor.
 */
public class LineMaster {
    private static final float EDGE = 0.40f;
    private static final int CRUISE = 100;
    private static final float GAIN = 450;
    /** All black: a line that goes off to the left. */
    private static final float BLACK = 0.25f;
    private static final float WHITE = 0.6f;
    /** A turn almost on the spot. */
    private static final int SHARP = 180;
    private static final int SLOW = 30;
    /** Turned right by so much on white, motor degrees of both wheels: a corner. */
    private static final int CORNER = 80;
    /** And by so much: no corner, but an end of the line. */
    private static final int LOST = 430;
    /** Has turned so much already before it is all white. */
    private static final int ASIDE = -25;
    /** Longest gap that is jumped over, motor degrees. */
    private static final int JUMP = 190;

    private final EV3LargeRegulatedMotor left = new EV3LargeRegulatedMotor(MotorPort.B);
    private final EV3LargeRegulatedMotor right = new EV3LargeRegulatedMotor(MotorPort.C);
    private final SampleProvider red = new EV3ColorSensor(SensorPort.S3).getRedMode();
    private final float[] sample = new float[1];

    public static void main(String[] args) {
        new LineMaster().follow();
    }

    private void follow() {
        int jumps = 0;
        int turned = turned();
        while (Button.ESCAPE.isUp()) {
            float brightness = brightness();
            turned = brightness < WHITE ? turned() : turned;
            int away = turned() - turned;
            if (away > LOST) {
                boolean found = jump(away);
                System.out.println(found ? "gap " + ++jumps : "end of line");
                turned = found ? turned() : Integer.MAX_VALUE / 2;
            } else if (away > CORNER) {
                drive(SLOW, SHARP);
            } else if (brightness < BLACK) {
                drive(SLOW, -SHARP);
            } else {
                drive(CRUISE, Math.round(GAIN * (brightness - EDGE)));
            }
        }
    }

    private float brightness() {
        red.fetchSample(sample, 0);
        return sample[0];
    }

    /** How far the robot has turned to the right, in motor degrees of both wheels together. */
    private int turned() {
        return left.getTachoCount() - right.getTachoCount();
    }

    /** Curves to the right, to the left if negative. */
    private void drive(int speed, int turn) {
        turn(left, speed + turn);
        turn(right, speed - turn);
    }

    private static void turn(EV3LargeRegulatedMotor motor, int speed) {
        motor.setSpeed(Math.abs(speed));
        if (speed >= 0) {
            motor.forward();
        } else {
            motor.backward();
        }
    }

    /** Back into the direction in which the line was left, then straight on; true if there is a line again, else all the way back. */
    private boolean jump(int lost) {
        turnRight(ASIDE - lost);
        int start = left.getTachoCount();
        drive(CRUISE, 0);
        while (left.getTachoCount() < start + JUMP) {
            if (brightness() < EDGE) {
                return true;
            }
        }
        int driven = left.getTachoCount() - start;
        move(-driven, -driven);
        turnRight(lost - ASIDE);
        return false;
    }

    private void turnRight(int degreesOfBoth) {
        move(degreesOfBoth / 2, -degreesOfBoth / 2);
    }

    private void move(int leftDegrees, int rightDegrees) {
        left.stop(true);
        right.stop();
        left.setSpeed(CRUISE);
        right.setSpeed(CRUISE);
        left.rotate(leftDegrees, true);
        right.rotate(rightDegrees);
        left.waitComplete();
    }
}
