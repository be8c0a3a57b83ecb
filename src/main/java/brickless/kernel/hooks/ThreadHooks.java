package brickless.kernel.hooks;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.TimeUnit;

/** {@code Thread}, {@code ThreadGroup}, {@code TimeUnit} and {@code LockSupport} of rewritten code. Per robot. */
public final class ThreadHooks {
    private static final long NANOS_PER_MILLI = 1_000_000L;

    private ThreadHooks() {}

    /** {@code Thread.sleep(millis)}. */
    public static void sleep(long millis) throws InterruptedException {
        Hooks.machine().sleep(MonitorHooks.nanos(millis, 0));
    }

    /** {@code Thread.sleep(millis, nanos)}. */
    public static void sleep(long millis, int nanos) throws InterruptedException {
        Hooks.machine().sleep(MonitorHooks.nanos(millis, nanos));
    }

    /** {@code Thread.sleep(duration)}; a negative duration does not sleep. */
    public static void sleep(Duration duration) throws InterruptedException {
        if (!duration.isNegative()) {
            Hooks.machine().sleep(TimeUnit.NANOSECONDS.convert(duration));
        }
    }

    /** {@code unit.sleep(amount)}. */
    public static void sleep(TimeUnit unit, long amount) throws InterruptedException {
        if (amount > 0) {
            Hooks.machine().sleep(unit.toNanos(amount));
        }
    }

    /** {@code unit.timedJoin(thread, amount)}. */
    public static void timedJoin(TimeUnit unit, Thread thread, long amount) throws InterruptedException {
        if (amount > 0) {
            Hooks.machine().join(thread, unit.toNanos(amount));
        }
    }

    /** {@code unit.timedWait(lock, amount)}. */
    public static void timedWait(TimeUnit unit, Object lock, long amount) throws InterruptedException {
        if (amount > 0) {
            Hooks.machine().monitorWait(lock, unit.toNanos(amount));
        }
    }

    /** {@code Thread.yield} and {@code Thread.onSpinWait}. */
    public static void yield() {
        Hooks.machine().yieldProcessor();
    }

    /** {@code Thread.currentThread}. */
    public static Thread currentThread() {
        return Hooks.machine().currentThread();
    }

    /** {@code Thread.interrupted}. */
    public static boolean interrupted() {
        return Hooks.machine().interrupted(Hooks.machine().currentThread(), true);
    }

    /** {@code Thread.activeCount}. */
    public static int activeCount() {
        return Hooks.machine().threads().length;
    }

    /** {@code Thread.enumerate}. */
    public static int enumerate(Thread[] found) {
        Thread[] threads = Hooks.machine().threads();
        int count = Math.min(found.length, threads.length);
        System.arraycopy(threads, 0, found, 0, count);
        return count;
    }

    /** {@code Thread.getAllStackTraces}: every thread with its own frames if it is the caller, else with none. */
    public static Map<Thread, StackTraceElement[]> getAllStackTraces() {
        Map<Thread, StackTraceElement[]> traces = new LinkedHashMap<>();
        for (Thread thread : Hooks.machine().threads()) {
            traces.put(thread, getStackTrace(thread));
        }
        return traces;
    }

    /** {@code thread.getStackTrace()}: the program's frames if the thread is the caller, else none. */
    public static StackTraceElement[] getStackTrace(Thread thread) {
        boolean own = thread == Hooks.machine().currentThread();
        return own ? ThrowableText.programFrames(new Throwable().getStackTrace()) : new StackTraceElement[0];
    }

    /** {@code Thread.dumpStack}. */
    public static void dumpStack() {
        ThrowableHooks.printStackTrace(new Exception("Stack trace"));
    }

    /** {@code Thread.setDefaultUncaughtExceptionHandler}. */
    public static void setDefaultUncaughtExceptionHandler(Thread.UncaughtExceptionHandler handler) {
        Hooks.machine().setDefaultUncaughtExceptionHandler(handler);
    }

    /** {@code Thread.getDefaultUncaughtExceptionHandler}. */
    public static Thread.UncaughtExceptionHandler getDefaultUncaughtExceptionHandler() {
        return Hooks.machine().getDefaultUncaughtExceptionHandler();
    }

    /** {@code thread.start()}, also for thread objects that the JDK made. */
    public static void start(Thread thread) {
        if (thread instanceof ProgramThread) {
            thread.start();
        } else {
            Hooks.machine().start(thread);
        }
    }

    /** {@code thread.join()}. */
    public static void join(Thread thread) throws InterruptedException {
        Hooks.machine().join(thread, 0);
    }

    /** {@code thread.join(millis)}. */
    public static void join(Thread thread, long millis) throws InterruptedException {
        Hooks.machine().join(thread, MonitorHooks.nanos(millis, 0));
    }

    /** {@code thread.join(millis, nanos)}. */
    public static void join(Thread thread, long millis, int nanos) throws InterruptedException {
        Hooks.machine().join(thread, MonitorHooks.nanos(millis, nanos));
    }

    /** {@code thread.interrupt()}. */
    public static void interrupt(Thread thread) {
        if (thread instanceof ProgramThread) {
            thread.interrupt();
        } else {
            Hooks.machine().interrupt(thread);
        }
    }

    /** {@code thread.isInterrupted()}. */
    public static boolean isInterrupted(Thread thread) {
        return thread instanceof ProgramThread ? thread.isInterrupted() : Hooks.machine().interrupted(thread, false);
    }

    /** {@code thread.isAlive()}. */
    public static boolean isAlive(Thread thread) {
        return Hooks.machine().isAlive(thread);
    }

    /** {@code thread.getState()}. */
    public static Thread.State getState(Thread thread) {
        return Hooks.machine().state(thread);
    }

    /** {@code thread.setDaemon(daemon)}. */
    public static void setDaemon(Thread thread, boolean daemon) {
        if (Hooks.machine().isAlive(thread)) {
            throw new IllegalThreadStateException();
        }
        thread.setDaemon(daemon);
    }

    /** {@code thread.threadId()}. */
    public static long threadId(Thread thread) {
        return thread.getId();
    }

    /** {@code Thread.stop}, {@code suspend}, {@code resume} and {@code destroy}: removed from Java, and never safe. */
    public static void unsupported(Thread thread) {
        throw new UnsupportedOperationException("Thread.stop, suspend and resume are not supported: use interrupt()");
    }

    /** {@code Thread.startVirtualThread}: a daemon thread like any other here. */
    public static Thread startVirtualThread(Runnable task) {
        Thread thread = new ProgramThread(task, "");
        thread.setDaemon(true);
        thread.start();
        return thread;
    }

    /** {@code group.activeCount()}. */
    public static int activeCount(ThreadGroup group) {
        return activeCount();
    }

    /** {@code group.enumerate(threads)}. */
    public static int enumerate(ThreadGroup group, Thread[] found) {
        return enumerate(found);
    }

    /** {@code group.interrupt()}. */
    public static void interrupt(ThreadGroup group) {
        for (Thread thread : Hooks.machine().threads()) {
            if (group.parentOf(thread.getThreadGroup())) {
                interrupt(thread);
            }
        }
    }

    /** {@code LockSupport.park()}. */
    public static void park() {
        Hooks.machine().park(0);
    }

    /** {@code LockSupport.park(blocker)}. */
    public static void park(Object blocker) {
        Hooks.machine().park(0);
    }

    /** {@code LockSupport.parkNanos(nanos)}. */
    public static void parkNanos(long nanos) {
        if (nanos > 0) {
            Hooks.machine().park(nanos);
        }
    }

    /** {@code LockSupport.parkNanos(blocker, nanos)}. */
    public static void parkNanos(Object blocker, long nanos) {
        parkNanos(nanos);
    }

    /** {@code LockSupport.parkUntil(deadlineMillis)}. */
    public static void parkUntil(long deadlineMillis) {
        parkNanos((deadlineMillis - Hooks.machine().currentTimeMillis()) * NANOS_PER_MILLI);
    }

    /** {@code LockSupport.parkUntil(blocker, deadlineMillis)}. */
    public static void parkUntil(Object blocker, long deadlineMillis) {
        parkUntil(deadlineMillis);
    }

    /** {@code LockSupport.unpark(thread)}. */
    public static void unpark(Thread thread) {
        if (thread != null) {
            Hooks.machine().unpark(thread);
        }
    }

    /** {@code LockSupport.setCurrentBlocker(blocker)}: only locks of ours say anything to the kernel. */
    public static void setCurrentBlocker(Object blocker) {
        Hooks.machine().waitsFor(blocker instanceof OwnedLock ? (OwnedLock) blocker : null);
    }
}
