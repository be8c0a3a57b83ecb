package lejos.robotics.subsumption;

/**
 * One thing a robot can do: when it wants to, how it does it, and how it is told to give way.
 *
 * <p>An {@link Arbitrator} calls {@link #takeControl} and {@link #suppress} on its monitor thread, never two of them at
 * once, and {@link #action} on the thread that called {@link Arbitrator#go}. Fields shared between them are therefore
 * shared between threads: declare them {@code volatile}.
 */
public interface Behavior {
    /**
     * Whether this behaviour wants to drive now. Asked many times a second, so return at once; keep answering true
     * until the action has started. Not asked while this behaviour or a higher one acts.
     */
    boolean takeControl();

    /**
     * Drives the robot. Returns when done, or soon after {@link #suppress} was called; until it returns no other
     * behaviour can act.
     */
    void action();

    /**
     * Tells the running {@link #action} to return, because a higher behaviour wants to drive. Must not wait for it.
     * Called again and again until the action has returned or the higher behaviour has lost interest.
     */
    void suppress();
}
