package handwritten;

/** What the next {@link StaticInitialiser} of a thread does. */
public final class StaticAction {
    private static final ThreadLocal<Runnable> ACTION = new ThreadLocal<>();

    private StaticAction() {
    }

    /** Sets the calling thread's action. */
    public static void set(Runnable action) {
        ACTION.set(action);
    }

    /** Runs the calling thread's action. */
    public static void run() {
        ACTION.get().run();
    }
}
