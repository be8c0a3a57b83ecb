package lejos.robotics.chassis;

import lejos.utility.Matrix;

/**
 * A change of speed that all motors finish at the same time, as soon as they can.
 *
 * @param change one column: how much each motor's speed changes, degrees per second
 * @param able one column: how fast it may change, degrees per second squared
 */
record VelocityRamp(Matrix change, Matrix able) {
    /**
     * Acceleration of a motor, at least 1. One whose speed seems right already may do what it can: perhaps it is about
     * to move.
     */
    int acceleration(int motor) {
        double share = Math.abs(change.get(motor, 0)) / seconds();
        double chosen = share >= 1 ? share : able.get(motor, 0);
        return Math.max(1, (int) chosen);
    }

    /** Time that the slowest motor needs. */
    private double seconds() {
        double seconds = 0;
        for (int i = 0; i < change.getRowDimension(); i++) {
            if (change.get(i, 0) != 0) {
                seconds = Math.max(seconds, Math.abs(change.get(i, 0)) / able.get(i, 0));
            }
        }
        return seconds;
    }
}
