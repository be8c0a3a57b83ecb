package lejos.utility;

/** Hears of a {@link Timer}. */
public interface TimerListener {
    /** The timer's delay is over. Called on the timer's thread. */
    void timedOut();
}
