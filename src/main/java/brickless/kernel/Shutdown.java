package brickless.kernel;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/**
 * {@code System.exit} and the end of the last thread: shutdown hooks run as ordinary threads in virtual time, then
 * the program is ended.
 */
final class Shutdown {
    private final Scheduler scheduler;
    private final VirtualClock clock;
    private final Ending ending;
    private final Consumer<Thread> starter;
    /** By registration: the JDK promises no order, ours is always the same. */
    private final List<Thread> hooks = new ArrayList<>();
    private boolean begun;
    private int status;

    Shutdown(Scheduler scheduler, VirtualClock clock, Ending ending, Consumer<Thread> starter) {
        this.scheduler = scheduler;
        this.clock = clock;
        this.ending = ending;
        this.starter = starter;
    }

    void addHook(Thread hook, boolean wasStarted) {
        checkNotBegun();
        if (isHook(hook)) {
            throw new IllegalArgumentException("Hook previously registered");
        }
        if (wasStarted) {
            throw new IllegalArgumentException("Hook already running");
        }
        hooks.add(hook);
    }

    boolean removeHook(Thread hook) {
        checkNotBegun();
        return hooks.removeIf(registered -> registered == hook);
    }

    /**
     * {@code System.exit}. The caller waits until all hooks have ended. A hook that calls it counts as ended (in a
     * JVM it would hang for ever).
     */
    void exit(int newStatus) {
        scheduler.enter();
        Fibre me = scheduler.current();
        if (begun) {
            ended(me);
        } else {
            begin(newStatus);
        }
        if (ending.killing()) {
            scheduler.exhaustBudget();
        }
        scheduler.block(FibreState.EXITING, 0);
        throw new IllegalStateException("an exiting thread was woken");
    }

    void halt(int newStatus) {
        scheduler.enter();
        ending.kill(ProgramEnd.Kind.EXITED, clock.now(), newStatus, "");
        scheduler.exhaustBudget();
        ending.throwIfKilling();
    }

    /** Starts the hooks, or ends the program if there are none or they have begun already. */
    void begin(int newStatus) {
        if (begun) {
            return;
        }
        begun = true;
        status = newStatus;
        List.copyOf(hooks).forEach(starter);
        killIfDone();
    }

    /** A fibre ended, or waits in exit for ever: perhaps it was the last hook. */
    void ended(Fibre fibre) {
        if (begun && hooks.removeIf(hook -> hook == fibre.thread)) {
            killIfDone();
        }
    }

    void clear() {
        hooks.clear();
    }

    private void killIfDone() {
        if (hooks.isEmpty()) {
            ending.kill(ProgramEnd.Kind.EXITED, clock.now(), status, "");
        }
    }

    private void checkNotBegun() {
        if (begun) {
            throw new IllegalStateException("Shutdown in progress");
        }
    }

    private boolean isHook(Thread thread) {
        return hooks.stream().anyMatch(hook -> hook == thread);
    }
}
