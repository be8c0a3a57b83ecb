package brickless.viewer;

/**
 * Which simulated time is due at a wall time. What could not be caught up for a while is dropped: the run is late from
 * then on but never races. Owned by the driver.
 */
final class Pacer {
    /** Assumption: catching up so much goes unnoticed. */
    private static final long LONGEST_LAG_NANOS = 150_000_000;
    /** The record of a run grows with its time: so long, 10 h, it goes on without anybody asking for more. */
    static final long REST_NANOS = 36_000_000_000_000L;

    private double speed;
    private long restNanos = REST_NANOS;
    private long wallNanos;
    private long simulatedNanos;

    Pacer(double speed) {
        this.speed = speed;
    }

    double speed() {
        return speed;
    }

    /** From now on time passes at this speed. */
    void setSpeed(double newSpeed, long nowNanos, long simulated) {
        speed = newSpeed;
        restart(nowNanos, simulated);
    }

    /** The run stands at a simulated time now, and goes on from there. */
    void restart(long nowNanos, long simulated) {
        wallNanos = nowNanos;
        simulatedNanos = simulated;
    }

    /** A new run begins. */
    void begin(long nowNanos) {
        restNanos = REST_NANOS;
        restart(nowNanos, 0);
    }

    /** Simulated time that the run should have reached. */
    long due(long nowNanos) {
        return speed == Speed.MAX ? restNanos
                : Math.min(restNanos, simulatedNanos + (long) ((nowNanos - wallNanos) * speed));
    }

    /**
     * The run got this far.
     *
     * @return whether it has run for so long that it should rest
     */
    boolean reached(long nowNanos, long simulated) {
        if (simulated >= restNanos) {
            restNanos += REST_NANOS;
            return true;
        }
        if (speed != Speed.MAX && due(nowNanos) - simulated > LONGEST_LAG_NANOS * speed) {
            restart(nowNanos, simulated);
        }
        return false;
    }
}
