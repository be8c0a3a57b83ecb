package brickless.kernel.hooks;

import java.io.InputStream;
import java.io.PrintStream;

/** {@code System} and {@code Runtime} of rewritten code: clock, exit, console, processors and memory. Per robot. */
public final class SystemHooks {
    /** Memory that a program sees, in bytes: about what the brick's JVM has. Assumption. */
    private static final long TOTAL_MEMORY_BYTES = 32L << 20;
    private static final long FREE_MEMORY_BYTES = 24L << 20;

    private SystemHooks() {}

    /** {@code System.currentTimeMillis}. */
    public static long currentTimeMillis() {
        return Hooks.machine().currentTimeMillis();
    }

    /** {@code System.nanoTime}. */
    public static long nanoTime() {
        return Hooks.machine().nanoTime();
    }

    /** {@code System.exit}; does not return. */
    public static void exit(int status) {
        Hooks.machine().exit(status);
    }

    /** {@code runtime.exit(status)}. */
    public static void exit(Runtime runtime, int status) {
        Hooks.machine().exit(status);
    }

    /** {@code runtime.halt(status)}. */
    public static void halt(Runtime runtime, int status) {
        Hooks.machine().halt(status);
    }

    /** {@code runtime.addShutdownHook(hook)}. */
    public static void addShutdownHook(Runtime runtime, Thread hook) {
        Hooks.machine().addShutdownHook(hook);
    }

    /** {@code runtime.removeShutdownHook(hook)}. */
    public static boolean removeShutdownHook(Runtime runtime, Thread hook) {
        return Hooks.machine().removeShutdownHook(hook);
    }

    /** {@code runtime.availableProcessors()}: the brick has one. */
    public static int availableProcessors(Runtime runtime) {
        return 1;
    }

    /** {@code runtime.totalMemory()} and {@code maxMemory()}. */
    public static long totalMemory(Runtime runtime) {
        return TOTAL_MEMORY_BYTES;
    }

    /** {@code runtime.freeMemory()}. */
    public static long freeMemory(Runtime runtime) {
        return FREE_MEMORY_BYTES;
    }

    /** {@code System.gc}, {@code System.runFinalization}: nothing that a program could see. */
    public static void gc() {}

    /** {@code runtime.gc()}, {@code runtime.runFinalization()}. */
    public static void gc(Runtime runtime) {}

    /** {@code System.out}. */
    public static PrintStream out() {
        return Hooks.machine().out();
    }

    /** {@code System.err}. */
    public static PrintStream err() {
        return Hooks.machine().err();
    }

    /** {@code System.in}. */
    public static InputStream in() {
        return Hooks.machine().in();
    }

    /** {@code System.setOut}. */
    public static void setOut(PrintStream stream) {
        Hooks.machine().setStreams(stream, null, null);
    }

    /** {@code System.setErr}. */
    public static void setErr(PrintStream stream) {
        Hooks.machine().setStreams(null, stream, null);
    }

    /** {@code System.setIn}. */
    public static void setIn(InputStream stream) {
        Hooks.machine().setStreams(null, null, stream);
    }
}
