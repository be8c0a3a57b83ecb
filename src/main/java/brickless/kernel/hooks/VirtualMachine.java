package brickless.kernel.hooks;

import brickless.files.BrickFiles;
import java.io.InputStream;
import java.io.PrintStream;

/**
 * What rewritten bytecode needs from the kernel of its robot. The kernel implements it; {@link Hooks} calls it.
 *
 * <p>Only the running fibre calls these methods. Times are virtual nanoseconds. Every method that can switch fibres,
 * and none other, may throw {@link ProgramKilled}.
 */
public interface VirtualMachine {
    /** The budget ran out: settle the clock, run due events, switch fibre if the slice is over. */
    void budgetExhausted();

    /** Charges time for an operation; may switch fibres. */
    void charge(long nanos);

    /** Whether the program is being ended: handlers must let {@link ProgramKilled} pass. */
    boolean killing();

    /**
     * A static initialiser that only computes begins or ends on the running fibre, which keeps the processor meanwhile:
     * no other one can come to need the class.
     */
    void undivided(boolean begins);

    /** The lock that the calling thread will wait for until it has it, null when that is over. */
    void waitsFor(OwnedLock lock);

    /** Acquires the virtual monitor of {@code lock}; blocks. Throws NullPointerException like the bytecode would. */
    void monitorEnter(Object lock);

    /** Releases the virtual monitor; never switches fibres and, while the program is being ended, never throws. */
    void monitorExit(Object lock);

    /** {@code Object.wait}; {@code nanos} 0 = for ever. */
    void monitorWait(Object lock, long nanos) throws InterruptedException;

    /** {@code Object.notify} or {@code notifyAll}. */
    void monitorNotify(Object lock, boolean all);

    /** {@code Thread.holdsLock}. */
    boolean holdsMonitor(Object lock);

    /** The program's thread object of the running fibre; null before the first one runs. */
    Thread currentThread();

    /** {@code Thread.start} of a program thread; never switches fibres. */
    void start(Thread thread);

    /** {@code Thread.sleep}. */
    void sleep(long nanos) throws InterruptedException;

    /** {@code Thread.yield} and {@code onSpinWait}. */
    void yieldProcessor();

    /** {@code Thread.join}; {@code nanos} 0 = for ever. */
    void join(Thread thread, long nanos) throws InterruptedException;

    /** {@code Thread.isAlive}. */
    boolean isAlive(Thread thread);

    /** {@code Thread.getState}. */
    Thread.State state(Thread thread);

    /** {@code Thread.interrupt}. */
    void interrupt(Thread thread);

    /** {@code isInterrupted} of any thread; clears the flag if {@code clear}. */
    boolean interrupted(Thread thread, boolean clear);

    /** Live program threads. */
    Thread[] threads();

    /** {@code LockSupport.park}: until unparked, interrupted or {@code nanos} (0 = for ever) have passed. */
    void park(long nanos);

    /** {@code LockSupport.unpark}. */
    void unpark(Thread thread);

    /** {@code Thread.setDefaultUncaughtExceptionHandler}; null removes it. */
    void setDefaultUncaughtExceptionHandler(Thread.UncaughtExceptionHandler handler);

    /** {@code Thread.getDefaultUncaughtExceptionHandler}. */
    Thread.UncaughtExceptionHandler getDefaultUncaughtExceptionHandler();

    /** {@code System.currentTimeMillis}; charges. */
    long currentTimeMillis();

    /** {@code System.nanoTime}; charges. */
    long nanoTime();

    /** {@code System.exit}: runs shutdown hooks, then ends the program. Does not return. */
    void exit(int status);

    /** {@code Runtime.halt}: ends the program without hooks. Does not return. */
    void halt(int status);

    /** {@code Runtime.addShutdownHook}. */
    void addShutdownHook(Thread hook);

    /** {@code Runtime.removeShutdownHook}. */
    boolean removeShutdownHook(Thread hook);

    /** Next value of the program's seeded random stream ({@code Math.random}, {@code new Random()} …). */
    long nextRandomLong();

    /** Next sequential identity hash. */
    int nextIdentityHash();

    /** Next number for {@code Thread-N}. */
    int nextThreadNumber();

    /** Next value of {@code Thread.getId}. */
    long nextThreadId();

    /** {@code System.out}. */
    PrintStream out();

    /** {@code System.err}. */
    PrintStream err();

    /** {@code System.in}. */
    InputStream in();

    /** {@code System.setOut}, {@code System.setErr} and {@code System.setIn}; null leaves a stream unchanged. */
    void setStreams(PrintStream out, PrintStream err, InputStream in);

    /** The files of the robot's brick; null: the program uses those of the host. */
    BrickFiles files();
}
