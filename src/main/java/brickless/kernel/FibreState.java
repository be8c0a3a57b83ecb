package brickless.kernel;

/** What a fibre does, with the state that {@code Thread.getState} reports for it without and with a time-out. */
enum FibreState {
    READY(Thread.State.RUNNABLE, Thread.State.RUNNABLE, false),
    RUNNING(Thread.State.RUNNABLE, Thread.State.RUNNABLE, false),
    SLEEPING(Thread.State.TIMED_WAITING, Thread.State.TIMED_WAITING, true),
    /** Waits for a monitor. */
    BLOCKED(Thread.State.BLOCKED, Thread.State.BLOCKED, false),
    /** In {@code Object.wait}. */
    WAITING(Thread.State.WAITING, Thread.State.TIMED_WAITING, true),
    JOINING(Thread.State.WAITING, Thread.State.TIMED_WAITING, true),
    PARKED(Thread.State.WAITING, Thread.State.TIMED_WAITING, true),
    /** Waits for a device. */
    SIGNAL(Thread.State.WAITING, Thread.State.TIMED_WAITING, false),
    /** Waits for a device and can be interrupted. */
    SIGNAL_INTERRUPTIBLY(Thread.State.WAITING, Thread.State.TIMED_WAITING, true),
    /** In {@code System.exit} while shutdown hooks run. */
    EXITING(Thread.State.WAITING, Thread.State.WAITING, false),
    ENDED(Thread.State.TERMINATED, Thread.State.TERMINATED, false);

    private final Thread.State untimed;
    private final Thread.State timed;
    private final boolean interruptible;

    FibreState(Thread.State untimed, Thread.State timed, boolean interruptible) {
        this.untimed = untimed;
        this.timed = timed;
        this.interruptible = interruptible;
    }

    Thread.State threadState(boolean withTimeout) {
        return withTimeout ? timed : untimed;
    }

    boolean interruptible() {
        return interruptible;
    }

    boolean waitsForDevice() {
        return this == SIGNAL || this == SIGNAL_INTERRUPTIBLY;
    }
}
