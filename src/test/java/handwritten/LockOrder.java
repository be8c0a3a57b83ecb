package handwritten;

import brickless.kernel.hooks.VirtualMachine;

/**
 * Two threads take two locks in opposite order, as rewriting would leave them: deadlocks if both get their first
 * lock.
 */
public final class LockOrder {
    private final VirtualMachine machine;
    private final Object one = new Object();
    private final StringBuilder two = new StringBuilder();

    /** Creates the program. */
    public LockOrder(VirtualMachine machine) {
        this.machine = machine;
    }

    /** The main method: starts "left" and "right", which do this often with a pause between the locks. */
    public void start(int rounds, long pauseNanos) {
        machine.start(thread("left", () -> takeBoth(one, two, rounds, pauseNanos)));
        machine.start(thread("right", () -> takeBoth(two, one, rounds, pauseNanos)));
    }

    private static Thread thread(String name, Runnable body) {
        Thread thread = new Thread(body, name);
        thread.setDaemon(false);
        return thread;
    }

    private void takeBoth(Object first, Object second, int rounds, long pauseNanos) {
        for (int i = 0; i < rounds; i++) {
            machine.monitorEnter(first);
            machine.charge(pauseNanos);
            machine.monitorEnter(second);
            machine.charge(pauseNanos);
            machine.monitorExit(second);
            machine.monitorExit(first);
        }
    }
}
