package brickless.device.motor;

import brickless.hardware.RegulationTuning;

/**
 * The controller that makes a motor follow its model: smoothed error, proportional, differential and integral parts.
 * Duty in percent.
 */
final class TrackingLoop {
    /** Period that gains and smoothing are meant for, milliseconds. */
    static final double PERIOD_MILLIS = 4;
    /** Errors up to this are no reason to move a motor that holds, degrees. */
    private static final double HOLD_DEAD_BAND = 0.5;
    private static final double FULL = 100;

    private RegulationTuning tuning = new RegulationTuning(4, 0.04f, 10, 2, 0.02f, 8, 0);
    private double fast;
    private double slow;
    private double base;

    void configure(RegulationTuning newTuning) {
        tuning = newTuning;
    }

    /** Forgets the past. */
    void reset() {
        fast = 0;
        slow = 0;
        base = 0;
    }

    /**
     * One cycle.
     *
     * @param error model position less encoder, degrees
     * @param hold whether the hold gains apply
     * @param elapsedMillis time since the last cycle
     * @return duty, a whole number of percent from −100 to 100
     */
    int duty(double error, boolean hold, double elapsedMillis) {
        double e = hold && Math.abs(error) <= HOLD_DEAD_BAND ? 0 : error;
        fast = 0.375 * fast + 0.625 * e;
        slow = 0.75 * slow + 0.25 * e;
        double cycles = elapsedMillis / PERIOD_MILLIS;
        double p = hold ? tuning.holdP() : tuning.moveP();
        double i = hold ? tuning.holdI() : tuning.moveI();
        double d = hold ? tuning.holdD() : tuning.moveD();
        double out = base + p * fast + d * (fast - slow) / cycles;
        base = clamp(base + i * (out - base) * cycles);
        double offset = Math.abs(out) < 0.5 ? 0 : out > 0 ? tuning.offsetPercent() : -tuning.offsetPercent();
        return (int) Math.round(clamp(out + offset));
    }

    private static double clamp(double value) {
        return Math.max(-FULL, Math.min(FULL, value));
    }
}
