package brickless.kernel.hooks;

/** The group of all program threads. One for the whole JVM: thread groups are never collected on JDK 17. Shared. */
public final class ProgramThreadGroup {
    /** Group {@code "main"}; holds no started JDK thread while a kernel is bound. */
    public static final ThreadGroup MAIN = new ThreadGroup("main");

    private ProgramThreadGroup() {}
}
