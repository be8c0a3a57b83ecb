package brickless.kernel.hooks;

/**
 * What is static in one or more classes of a robot, kept while another robot that shares the classes has the processor.
 * Shared; used by whoever exchanges the robots, while no code of theirs runs.
 */
public abstract class StaticState {
    /** For subclasses. */
    protected StaticState() {}

    /** Takes the present values of the static fields. */
    public abstract void save();

    /**
     * Whether {@link #save} need not be called again, because the values that were taken last cannot change any more.
     */
    public abstract boolean isFinal();

    /** Gives the static fields their values back. */
    public abstract void load();
}
