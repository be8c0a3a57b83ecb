package explorer;

import lejos.robotics.RegulatedMotor;

/** The two driven wheels. */
class Wheels {
    private final RegulatedMotor left;
    private final RegulatedMotor right;

    Wheels(RegulatedMotor left, RegulatedMotor right) {
        this.left = left;
        this.right = right;
    }

    void forward(int speed) {
        left.setSpeed(speed);
        right.setSpeed(speed);
        left.forward();
        right.forward();
    }

    void backward(int speed) {
        left.setSpeed(speed);
        right.setSpeed(speed);
        left.backward();
        right.backward();
    }

    /** Starts turning on the spot; positive degrees of the wheels turn right. */
    void spin(int wheelDegrees) {
        left.setSpeed(240);
        right.setSpeed(240);
        left.rotate(wheelDegrees, true);
        right.rotate(-wheelDegrees, true);
    }

    boolean moving() {
        return left.isMoving() || right.isMoving();
    }

    void stop() {
        left.stop(true);
        right.stop();
    }
}
