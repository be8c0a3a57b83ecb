package brickless.kernel.hooks;

import brickless.files.BrickFiles;
import java.io.InputStream;
import java.io.PrintStream;
import java.util.concurrent.ThreadLocalRandom;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;

/**
 * Stands in for the kernel until one is bound: every hook does what the plain JDK call would have done, on real threads
 * and the wall clock. Per robot.
 */
final class HostMachine implements VirtualMachine {
    private static final int FIRST_THREAD_ID = 1;

    private final HostMonitors monitors = new HostMonitors();
    private final AtomicInteger identityHashes = new AtomicInteger();
    private final AtomicInteger threadNumbers = new AtomicInteger();
    private final AtomicInteger threadIds = new AtomicInteger(FIRST_THREAD_ID);

    @Override
    public void budgetExhausted() {
        Hooks.left = Integer.MAX_VALUE;
    }

    @Override
    public void charge(long nanos) {
        Hooks.left = Integer.MAX_VALUE;
    }

    @Override
    public void waitsFor(OwnedLock lock) {
        // Nobody looks for deadlocks on the host.
    }

    @Override
    public void undivided(boolean begins) {
        // The host's threads wait for each other as they should.
    }

    @Override
    public boolean killing() {
        return false;
    }

    @Override
    public void monitorEnter(Object lock) {
        monitors.enter(lock);
    }

    @Override
    public void monitorExit(Object lock) {
        monitors.exit(lock);
    }

    @Override
    public void monitorWait(Object lock, long nanos) throws InterruptedException {
        monitors.await(lock, nanos);
    }

    @Override
    public void monitorNotify(Object lock, boolean all) {
        monitors.signal(lock, all);
    }

    @Override
    public boolean holdsMonitor(Object lock) {
        return monitors.held(lock) || Thread.holdsLock(lock);
    }

    @Override
    public Thread currentThread() {
        return Thread.currentThread();
    }

    @Override
    public void start(Thread thread) {
        if (thread instanceof ProgramThread) {
            ((ProgramThread) thread).startOnHost();
        } else {
            thread.start();
        }
    }

    @Override
    public void sleep(long nanos) throws InterruptedException {
        TimeUnit.NANOSECONDS.sleep(nanos);
    }

    @Override
    public void yieldProcessor() {
        Thread.yield();
    }

    @Override
    public void join(Thread thread, long nanos) throws InterruptedException {
        if (nanos == 0) {
            thread.join();
        } else {
            TimeUnit.NANOSECONDS.timedJoin(thread, nanos);
        }
    }

    @Override
    public boolean isAlive(Thread thread) {
        return thread.isAlive();
    }

    @Override
    public Thread.State state(Thread thread) {
        return thread instanceof ProgramThread ? ((ProgramThread) thread).stateOnHost() : thread.getState();
    }

    @Override
    public void interrupt(Thread thread) {
        if (thread instanceof ProgramThread) {
            ((ProgramThread) thread).interruptOnHost();
        } else {
            thread.interrupt();
        }
    }

    @Override
    public boolean interrupted(Thread thread, boolean clear) {
        if (clear) {
            return Thread.interrupted();
        }
        return thread instanceof ProgramThread ? ((ProgramThread) thread).isInterruptedOnHost()
                : thread.isInterrupted();
    }

    @Override
    public Thread[] threads() {
        return Thread.getAllStackTraces().keySet().toArray(new Thread[0]);
    }

    @Override
    public void park(long nanos) {
        if (nanos == 0) {
            LockSupport.park();
        } else {
            LockSupport.parkNanos(nanos);
        }
    }

    @Override
    public void unpark(Thread thread) {
        LockSupport.unpark(thread);
    }

    @Override
    public void setDefaultUncaughtExceptionHandler(Thread.UncaughtExceptionHandler handler) {
        Thread.setDefaultUncaughtExceptionHandler(handler);
    }

    @Override
    public Thread.UncaughtExceptionHandler getDefaultUncaughtExceptionHandler() {
        return Thread.getDefaultUncaughtExceptionHandler();
    }

    @Override
    public long currentTimeMillis() {
        return System.currentTimeMillis();
    }

    @Override
    public long nanoTime() {
        return System.nanoTime();
    }

    @Override
    public void exit(int status) {
        Runtime.getRuntime().exit(status);
    }

    @Override
    public void halt(int status) {
        Runtime.getRuntime().halt(status);
    }

    @Override
    public void addShutdownHook(Thread hook) {
        Runtime.getRuntime().addShutdownHook(hook);
    }

    @Override
    public boolean removeShutdownHook(Thread hook) {
        return Runtime.getRuntime().removeShutdownHook(hook);
    }

    @Override
    public long nextRandomLong() {
        return ThreadLocalRandom.current().nextLong();
    }

    @Override
    public int nextIdentityHash() {
        return identityHashes.incrementAndGet();
    }

    @Override
    public int nextThreadNumber() {
        return threadNumbers.getAndIncrement();
    }

    @Override
    public long nextThreadId() {
        return threadIds.getAndIncrement();
    }

    @Override
    public PrintStream out() {
        return System.out;
    }

    @Override
    public PrintStream err() {
        return System.err;
    }

    @Override
    public InputStream in() {
        return System.in;
    }

    @Override
    public void setStreams(PrintStream out, PrintStream err, InputStream in) {
        if (out != null) {
            System.setOut(out);
        }
        if (err != null) {
            System.setErr(err);
        }
        if (in != null) {
            System.setIn(in);
        }
    }

    @Override
    public BrickFiles files() {
        return null;
    }
}
