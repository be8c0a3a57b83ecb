package brickless.hardware;

/** The keys as a bit mask: UP 1, ENTER 2, DOWN 4, RIGHT 8, LEFT 16, ESCAPE 32. */
public interface KeySocket {
    /** All keys. */
    int ALL_KEYS = 0x3f;

    /** Keys that are down now, physical and simulated together. Does not block. */
    default int pressed() {
        return pressed(ALL_KEYS);
    }

    /**
     * Keys that are down now, for a program that asks for some of them. Does not block.
     *
     * @param asked keys the program asks for: somebody may press one for a program that asks in vain
     * @return all keys that are down, also others than those
     */
    int pressed(int asked);

    /**
     * Blocks until {@link #pressed()} differs from {@code known}.
     *
     * @param timeoutNanos longest wait in nanoseconds, 0 = for ever
     * @return the mask at the end of the wait
     * @throws InterruptedException if the calling program thread is interrupted
     */
    int awaitChange(int known, long timeoutNanos) throws InterruptedException;

    /**
     * Blocks like {@link #awaitChange} without time limit, on behalf of key listeners: the program itself goes on, so
     * nobody is expected to press a key for it.
     *
     * @throws InterruptedException if the calling program thread is interrupted
     */
    int awaitListenerEvent(int known) throws InterruptedException;

    /** Presses or releases a key by program ({@code Key.simulateEvent}). */
    void simulate(int keyMask, boolean down);

    /**
     * Whether somebody watches the brick and can press keys. If not, nothing waits for a key that only dismisses a
     * message.
     */
    boolean attended();
}
