package lejos.hardware.motor;

/** Control law that keeps a motor on its planned position. Errors in degrees, power in percent. */
final class TrackingLoop {
    /** Gains of one situation. */
    record Gains(double proportional, double integral, double differential) {}

    private static final double PERIOD_MILLIS = 4;
    private static final int FULL_POWER = 100;

    /** Error smoothed a little. */
    private double quickError;
    /** Error smoothed more; the difference of both stands for its rate. */
    private double slowError;
    /** Power found to be needed so far. */
    private double basePower;

    /** Forgets the past. */
    void reset() {
        quickError = 0;
        slowError = 0;
        basePower = 0;
    }

    /**
     * One period of the loop.
     *
     * @param error planned minus measured position
     * @param elapsedMillis time since the last period, above 0
     * @return power from −100 to 100
     */
    int power(double error, double elapsedMillis, Gains gains) {
        double periods = elapsedMillis / PERIOD_MILLIS;
        quickError = 0.375 * quickError + 0.625 * error;
        slowError = 0.75 * slowError + 0.25 * error;
        double power = basePower + gains.proportional() * quickError
                + gains.differential() * (quickError - slowError) / periods;
        basePower = clamp(basePower + gains.integral() * (power - basePower) * periods);
        return (int) Math.round(clamp(power));
    }

    private static double clamp(double power) {
        return Math.max(-FULL_POWER, Math.min(FULL_POWER, power));
    }
}
