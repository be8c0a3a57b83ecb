package brickless.kernel.hooks;

/**
 * A lock, not a monitor, that one thread holds at a time. A thread that waits for it without limit and without minding
 * interrupts says so by {@code LockSupport.setCurrentBlocker}, so that deadlocks through it are found. Shared.
 */
public interface OwnedLock {
    /**
     * The thread without which the lock is not free, null if there is none. Called by the kernel: must neither call nor
     * lock anything.
     */
    Thread lockOwner();
}
