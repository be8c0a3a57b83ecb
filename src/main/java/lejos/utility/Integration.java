package lejos.utility;

/** Integrates readings over time by the trapezoidal rule. */
public class Integration {
    private static final double MILLIS_PER_SECOND = 1000;

    private double integral;
    private double lastReading;
    private long lastMillis;

    /**
     * Starts now.
     *
     * @param initialValue integral at the start
     * @param firstReading reading at the start
     */
    public Integration(double initialValue, double firstReading) {
        integral = initialValue;
        lastReading = firstReading;
        lastMillis = System.currentTimeMillis();
    }

    /**
     * Adds a reading taken now.
     *
     * @return the integral so far, in units of the readings times seconds
     */
    public double addReading(double reading) {
        long now = System.currentTimeMillis();
        integral += (reading + lastReading) / 2 * ((now - lastMillis) / MILLIS_PER_SECOND);
        lastReading = reading;
        lastMillis = now;
        return integral;
    }
}
