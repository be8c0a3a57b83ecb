package lejos.robotics.navigation;

import lejos.robotics.RegulatedMotor;

/**
 * One of two driving wheels.
 *
 * @param motor its motor
 * @param degPerDistance degrees the motor turns per unit of distance
 * @param turnRatio degrees the motor turns per degree the robot turns on the spot
 * @param parity 1, or −1 if the motor runs in reverse
 */
record DriveWheel(RegulatedMotor motor, float degPerDistance, float turnRatio, int parity) {
    private static final double FULL_TURN = 360;

    static DriveWheel of(RegulatedMotor motor, double diameter, double trackWidth, boolean reverse) {
        return new DriveWheel(motor, (float) (FULL_TURN / (Math.PI * diameter)), (float) (trackWidth / diameter),
                reverse ? -1 : 1);
    }

    /** Degrees turned, forward positive. */
    int turned() {
        return parity * motor.getTachoCount();
    }

    /** Speed now in degrees per second, forward positive. */
    int rotationSpeed() {
        return parity * motor.getRotationSpeed();
    }

    void setLinearSpeed(double speed) {
        motor.setSpeed((int) Math.round(speed * degPerDistance));
    }

    void setAngularSpeed(double speed) {
        motor.setSpeed((int) Math.round(speed * turnRatio));
    }

    /** Sets an acceleration in units per second squared. */
    void setAcceleration(double acceleration) {
        motor.setAcceleration(Math.max(1, (int) (acceleration * degPerDistance)));
    }

    /** Begins to turn forward, backward or not at all. */
    void run(double direction) {
        if (direction * parity > 0) {
            motor.forward();
        } else if (direction * parity < 0) {
            motor.backward();
        } else {
            motor.stop(true);
        }
    }

    /** Begins to turn by an angle in degrees, forward positive; fractions are dropped. */
    void rotate(double degrees) {
        motor.rotate((int) (parity * degrees), true);
    }
}
