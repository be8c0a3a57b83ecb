package brickless.kernel;

import brickless.files.BrickFiles;
import brickless.kernel.hooks.Budget;
import brickless.kernel.hooks.OwnedLock;
import brickless.kernel.hooks.ProgramKilled;
import brickless.kernel.hooks.VirtualMachine;
import java.io.InputStream;
import java.io.PrintStream;
import java.util.List;
import java.util.Objects;

/**
 * Runs one robot program in virtual time: what a JVM and an operating system would do for it, done deterministically.
 *
 * <pre>
 * Kernel kernel = new Kernel(KernelSettings.defaults().withLimitNanos(60_000_000_000L), world::step);
 * kernel.bind(budget);
 * ProgramEnd end = kernel.run(mainThread, () -&gt; Main.main(args));
 * </pre>
 *
 * <p>A kernel runs once. Methods of {@link VirtualMachine}, {@link #charge}, {@link #progress} and waits for signals
 * belong to the program's threads; {@link #at}, signals, {@link #goalReached}, {@link #timeUp} and {@link #fail} to
 * them, to step handlers and to events. Kernels share nothing with each other: any number may run at the same time on
 * different host threads.
 */
public final class Kernel implements VirtualMachine, Processor {
    private static final int NANOS_PER_MILLI = 1_000_000;

    private final KernelSettings settings;
    private final StepHandler stepHandler;
    private final Ending ending = new Ending();
    private final Roster roster = new Roster();
    private final VirtualClock clock;
    private final Scheduler scheduler;
    private final Monitors monitors;
    private final Threads threads;
    private final Shutdown shutdown;
    private final UncaughtExceptions uncaughtExceptions = new UncaughtExceptions(ending);
    private final Identities identities;
    private final Streams streams = new Streams();
    private KernelListener listener = new KernelListener() { };
    private BrickFiles files;
    private String backendName;
    private Thread mainThread;
    private Runnable mainBody;
    private ClassLoader contextLoader;
    private Runnable beforeTurn = () -> { };

    /** A kernel for an {@link Ensemble}, which has the step handler, or for a run without physics. */
    public Kernel(KernelSettings settings) {
        this(settings, null);
    }

    /**
     * Creates a kernel.
     *
     * @param stepHandler called at each multiple of the step length, or null
     */
    public Kernel(KernelSettings settings, StepHandler stepHandler) {
        this.settings = Objects.requireNonNull(settings, "settings");
        this.stepHandler = stepHandler;
        clock = new VirtualClock(settings, ending);
        scheduler = new Scheduler(clock, ending, Schedule.of(settings.scheduleSeed()), roster);
        monitors = new Monitors(scheduler, clock, ending);
        threads = new Threads(scheduler, clock, ending, roster, settings.maximumThreads());
        shutdown = new Shutdown(scheduler, clock, ending, hook -> admit(hook, hook));
        identities = new Identities(settings.seed());
    }

    /** Connects the counters that the program's rewritten code uses; before the run. */
    public void bind(Budget budget) {
        clock.bind(Objects.requireNonNull(budget, "budget"));
    }

    /**
     * Sets what happens before a thread of the program runs, after one of another kernel of the same {@link Ensemble}:
     * where programs share classes, what is static in them is exchanged. Before the run.
     */
    public void beforeTurn(Runnable action) {
        beforeTurn = Objects.requireNonNull(action, "action");
    }

    /** Gives the program files of its own; before the run. Without it uses those of the host. */
    public void files(BrickFiles brickFiles) {
        files = Objects.requireNonNull(brickFiles, "files");
    }

    /** Sets who hears what happens; before the run. */
    public void listen(KernelListener newListener) {
        listener = Objects.requireNonNull(newListener, "listener");
        scheduler.listen(newListener);
        uncaughtExceptions.listen(newListener);
    }

    /** Sets the program's main thread and what it does; before {@link Ensemble#run}. */
    public void main(Thread thread, Runnable body) {
        if (mainThread != null || ending.killing()) {
            throw new IllegalStateException("a kernel runs one program, once");
        }
        mainThread = Objects.requireNonNull(thread, "thread");
        mainBody = Objects.requireNonNull(body, "body");
    }

    /**
     * Runs a program to its end on host threads of its own and waits for it.
     *
     * @throws java.util.concurrent.CancellationException if the calling thread is interrupted: the program is then
     *     ended and the interrupt flag kept
     */
    public ProgramEnd run(Thread thread, Runnable body) {
        main(thread, body);
        return new Ensemble(List.of(this), stepHandler).run().get(0);
    }

    /** The settings. */
    public KernelSettings settings() {
        return settings;
    }

    /** Physics steps so far. */
    public long physicsSteps() {
        return clock.steps();
    }

    /** Switches from one program thread to another so far. */
    public long contextSwitches() {
        return scheduler.switches();
    }

    /** {@code threads} or {@code continuation}; null before the run. */
    public String backendName() {
        return backendName;
    }

    /** How the program ended, or null if it has not. */
    public ProgramEnd end() {
        return ending.end();
    }

    /** The program's threads, as in a deadlock's dump; during the run. */
    public String dump(String title) {
        return new ThreadDump(title, clock.now(), scheduler.backend()).of(List.copyOf(roster.live()));
    }

    /**
     * Runs an action at a virtual time, between program instructions; a time that has passed means as soon as
     * possible.
     */
    public void at(long timeNanos, Runnable action) {
        clock.schedule(new Event(Objects.requireNonNull(action, "action")), timeNanos);
    }

    /** Ends the run: the goal is reached. */
    public void goalReached() {
        end(ProgramEnd.Kind.GOAL_REACHED);
    }

    /** Ends the run as at its time limit. */
    public void timeUp() {
        end(ProgramEnd.Kind.TIME_LIMIT);
    }

    /** Ends the run as failed, for something that happened in the world. */
    public void fail(Throwable cause) {
        ending.uncaught(Objects.requireNonNull(cause, "cause"));
        end(ProgramEnd.Kind.FAILED);
    }

    @Override
    public long nowNanos() {
        return ending.killing() ? ending.end().timeNanos() : clock.now();
    }

    @Override
    public void charge(long nanos) {
        scheduler.charge(nanos);
    }

    @Override
    public void progress() {
        scheduler.current().yields = 0;
    }

    @Override
    public Signal newSignal() {
        return new KernelSignal(scheduler);
    }

    @Override
    public void budgetExhausted() {
        scheduler.charge(0);
    }

    @Override
    public boolean killing() {
        return ending.killing();
    }

    @Override
    public void undivided(boolean begins) {
        scheduler.undivided(begins);
    }

    @Override
    public void waitsFor(OwnedLock lock) {
        scheduler.current().blocker = lock;
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
        monitors.notify(lock, all);
    }

    @Override
    public boolean holdsMonitor(Object lock) {
        return monitors.holds(lock);
    }

    @Override
    public Thread currentThread() {
        Fibre current = scheduler.current();
        return current == null ? null : current.thread;
    }

    @Override
    public void start(Thread thread) {
        threads.checkStartable(thread);
        if (!ending.killing()) {
            clock.spendUnseen(Costs.THREAD_START_NANOS);
            admit(thread, thread);
        }
    }

    @Override
    public void sleep(long nanos) throws InterruptedException {
        threads.sleep(nanos);
    }

    @Override
    public void yieldProcessor() {
        scheduler.yieldProcessor();
    }

    @Override
    public void join(Thread thread, long nanos) throws InterruptedException {
        threads.join(thread, nanos);
    }

    @Override
    public boolean isAlive(Thread thread) {
        return threads.isAlive(thread);
    }

    @Override
    public Thread.State state(Thread thread) {
        return threads.state(thread);
    }

    @Override
    public void interrupt(Thread thread) {
        threads.interrupt(thread);
    }

    @Override
    public boolean interrupted(Thread thread, boolean clear) {
        return threads.interrupted(thread, clear);
    }

    @Override
    public Thread[] threads() {
        return threads.live();
    }

    @Override
    public void park(long nanos) {
        threads.park(nanos);
    }

    @Override
    public void unpark(Thread thread) {
        threads.unpark(thread);
    }

    @Override
    public void setDefaultUncaughtExceptionHandler(Thread.UncaughtExceptionHandler handler) {
        uncaughtExceptions.defaultHandler(handler);
    }

    @Override
    public Thread.UncaughtExceptionHandler getDefaultUncaughtExceptionHandler() {
        return uncaughtExceptions.defaultHandler();
    }

    @Override
    public long currentTimeMillis() {
        charge(Costs.CLOCK_READ_NANOS);
        return settings.epochMillis() + clock.now() / NANOS_PER_MILLI;
    }

    @Override
    public long nanoTime() {
        charge(Costs.CLOCK_READ_NANOS);
        return clock.now();
    }

    @Override
    public void exit(int status) {
        shutdown.exit(status);
    }

    @Override
    public void halt(int status) {
        shutdown.halt(status);
    }

    @Override
    public void addShutdownHook(Thread hook) {
        shutdown.addHook(hook, roster.of(hook) != null);
    }

    @Override
    public boolean removeShutdownHook(Thread hook) {
        return shutdown.removeHook(Objects.requireNonNull(hook));
    }

    @Override
    public long nextRandomLong() {
        return identities.nextRandomLong();
    }

    @Override
    public int nextIdentityHash() {
        return identities.nextHash();
    }

    @Override
    public int nextThreadNumber() {
        return identities.nextThreadNumber();
    }

    @Override
    public long nextThreadId() {
        return identities.nextThreadId();
    }

    @Override
    public PrintStream out() {
        return streams.out();
    }

    @Override
    public PrintStream err() {
        return streams.err();
    }

    @Override
    public InputStream in() {
        return streams.in();
    }

    @Override
    public void setStreams(PrintStream out, PrintStream err, InputStream in) {
        streams.set(out, err, in);
    }

    @Override
    public BrickFiles files() {
        return files;
    }

    /**
     * Makes the main thread ready to run.
     *
     * @param steps whether there is physics, so that {@link #proceed} stops at each step
     */
    void prepare(Turns turns, boolean steps, Backend backend, Heartbeat heartbeat) {
        if (mainThread == null || clock.budget() == null) {
            throw new IllegalStateException("the kernel needs bind(…) and main(…) before it runs");
        }
        contextLoader = mainThread.getContextClassLoader();
        if (steps) {
            clock.stopAtSteps();
        }
        backendName = backend.name();
        scheduler.attach(backend, heartbeat, turns);
        admit(mainThread, mainBody);
        scheduler.begin();
    }

    /**
     * Goes on, on the stack of whoever has the host's turn, until a fibre is to run: returns it. Null if there is
     * nothing left to do before the next physics step, or at all.
     */
    Fibre proceed() {
        return scheduler.proceed();
    }

    /** Whether all threads have ended and unwound. */
    boolean over() {
        return scheduler.over();
    }

    /** The fibre that runs when it is this kernel's turn, or that ran last. */
    Fibre currentFibre() {
        return scheduler.current();
    }

    /** A thread of the program is about to run. */
    void takeTurn() {
        beforeTurn.run();
    }

    Ending ending() {
        return ending;
    }

    /** Lets go of all that belongs to the program, unless a runaway may still use it. */
    void release() {
        if (ending.abandoned()) {
            return;
        }
        scheduler.release();
        monitors.clear();
        roster.clear();
        clock.clear();
        shutdown.clear();
        uncaughtExceptions.defaultHandler(null);
        mainThread = null;
        mainBody = null;
        contextLoader = null;
        beforeTurn = () -> { };
    }

    private void end(ProgramEnd.Kind kind) {
        ending.kill(kind, clock.now(), 0, "");
        if (!clock.advancing()) {
            scheduler.exhaustBudget();
        }
    }

    private void admit(Thread thread, Runnable body) {
        Fibre fibre = new Fibre(
                roster.nextId(), thread, contextLoader, self -> runToEnd(self, body), scheduler::timedOut);
        roster.add(fibre);
        scheduler.admit(fibre);
    }

    /** The life of a fibre, on its own stack. */
    private void runToEnd(Fibre fibre, Runnable body) {
        try {
            body.run();
        } catch (ProgramKilled e) {
            // Unwound on purpose: the end of the program is on record already.
            assert ending.killing();
        } catch (Throwable e) {
            thrown(fibre, e);
        }
        if (!ending.abandoned()) {
            leave(fibre);
        }
    }

    /** What a program throws while it is being ended is nobody's concern. */
    private void thrown(Fibre fibre, Throwable failure) {
        if (!ending.killing()) {
            uncaughtExceptions.thrown(fibre.thread, failure);
        }
    }

    private void leave(Fibre fibre) {
        threads.ended(fibre);
        monitors.threadEnded(fibre.thread);
        listener.ended(nowNanos(), fibre.thread);
        shutdown.ended(fibre);
        if (roster.nonDaemons() == 0 && !ending.killing()) {
            shutdown.begin(0);
        }
        Backend backend = scheduler.backend();
        backend.finish(fibre, scheduler.successor());
    }
}
