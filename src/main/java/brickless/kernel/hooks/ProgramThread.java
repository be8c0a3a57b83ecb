package brickless.kernel.hooks;

/**
 * What {@code new Thread} and {@code extends Thread} become in a rewritten program: a thread object whose fibre the
 * kernel runs.
 *
 * <p>It is never started as a JDK thread unless no kernel is bound. Names, ids and hash codes count up per robot. Per
 * robot.
 */
public class ProgramThread extends Thread implements IdentityHashed {
    private final long id = Hooks.machine().nextThreadId();
    private final int identityHash = Hooks.machine().nextIdentityHash();
    private final ThreadLocalValues localValues;

    /** Like {@link Thread#Thread()}. */
    public ProgramThread() {
        this(null, null, nextName(), 0, true);
    }

    /** Like {@link Thread#Thread(Runnable)}. */
    public ProgramThread(Runnable target) {
        this(null, target, nextName(), 0, true);
    }

    /** Like {@link Thread#Thread(ThreadGroup, Runnable)}. */
    public ProgramThread(ThreadGroup group, Runnable target) {
        this(group, target, nextName(), 0, true);
    }

    /** Like {@link Thread#Thread(String)}. */
    public ProgramThread(String name) {
        this(null, null, name, 0, true);
    }

    /** Like {@link Thread#Thread(ThreadGroup, String)}. */
    public ProgramThread(ThreadGroup group, String name) {
        this(group, null, name, 0, true);
    }

    /** Like {@link Thread#Thread(Runnable, String)}. */
    public ProgramThread(Runnable target, String name) {
        this(null, target, name, 0, true);
    }

    /** Like {@link Thread#Thread(ThreadGroup, Runnable, String)}. */
    public ProgramThread(ThreadGroup group, Runnable target, String name) {
        this(group, target, name, 0, true);
    }

    /** Like {@link Thread#Thread(ThreadGroup, Runnable, String, long)}. */
    public ProgramThread(ThreadGroup group, Runnable target, String name, long stackSize) {
        this(group, target, name, stackSize, true);
    }

    /** Like {@link Thread#Thread(ThreadGroup, Runnable, String, long, boolean)}. */
    public ProgramThread(ThreadGroup group, Runnable target, String name, long stackSize, boolean inheritThreadLocals) {
        super(group == null ? ProgramThreadGroup.MAIN : group, target, name, stackSize, false);
        localValues = inheritThreadLocals ? ThreadLocalValues.inheritedFromCurrentThread() : new ThreadLocalValues();
        setContextClassLoader(ProgramThread.class.getClassLoader());
        inheritFromCreator();
    }

    private void inheritFromCreator() {
        Thread creator = Hooks.machine().currentThread();
        if (creator instanceof ProgramThread) {
            setDaemon(creator.isDaemon());
            setPriority(creator.getPriority());
        } else {
            setDaemon(false);
            setPriority(NORM_PRIORITY);
        }
    }

    private static String nextName() {
        return "Thread-" + Hooks.machine().nextThreadNumber();
    }

    /** Starts the fibre. */
    @Override
    public void start() {
        Hooks.machine().start(this);
    }

    /** Starts a JDK thread; what {@link #start} does while no kernel is bound. */
    final void startOnHost() {
        super.start();
    }

    @Override
    public void interrupt() {
        Hooks.machine().interrupt(this);
    }

    /** Sets the JDK's own interrupt flag; what {@link #interrupt} does while no kernel is bound. */
    final void interruptOnHost() {
        super.interrupt();
    }

    @Override
    public boolean isInterrupted() {
        return Hooks.machine().interrupted(this, false);
    }

    final boolean isInterruptedOnHost() {
        return super.isInterrupted();
    }

    /** Counts up from the main thread's 1. */
    @Override
    public long getId() {
        return id;
    }

    @Override
    public State getState() {
        return Hooks.machine().state(this);
    }

    final State stateOnHost() {
        return super.getState();
    }

    @Override
    public StackTraceElement[] getStackTrace() {
        return ThrowableText.programFrames(super.getStackTrace());
    }

    @Override
    public String toString() {
        return "Thread[" + getName() + "," + getPriority() + "," + getThreadGroup().getName() + "]";
    }

    @Override
    public int hashCode() {
        return identityHash;
    }

    @Override
    public boolean equals(Object other) {
        return this == other;
    }

    @Override
    public int bricklessIdentityHash() {
        return identityHash;
    }

    /** The values of this thread's thread locals; only this thread's own fibre uses them. */
    final ThreadLocalValues localValues() {
        return localValues;
    }
}
