package brickless.device.panel;

/**
 * The two combinations that the brick itself obeys: DOWN with ENTER ends the program, LEFT with RIGHT shows the next
 * layer of the screen. The brick looks for them 5 and 10 times a second, so shorter presses go unseen. Guarded by the
 * simulation's thread: only {@link #step} touches it.
 */
public final class KeyChords {
    private static final int DOWN_ENTER = 4 | 2;
    private static final int LEFT_RIGHT = 16 | 8;
    private static final long LOOK_NANOS = 100_000_000;

    private final KeyPad keys;
    private final ScreenPanel screen;
    private final Runnable endProgram;
    private long nextLookNanos;
    private boolean secondLook;
    private int seen;

    /**
     * Watches a key pad.
     *
     * @param endProgram called once each time DOWN and ENTER are found held together
     */
    public KeyChords(KeyPad keys, ScreenPanel screen, Runnable endProgram) {
        this.keys = keys;
        this.screen = screen;
        this.endProgram = endProgram;
    }

    /** Until this time {@link #step} does nothing. */
    public long nextLookNanos() {
        return nextLookNanos;
    }

    /** Looks at the keys if it is time to; called at each physics step with the present time. */
    public void step(long nowNanos) {
        if (nowNanos < nextLookNanos) {
            return;
        }
        nextLookNanos = (nowNanos / LOOK_NANOS + 1) * LOOK_NANOS;
        int held = keys.heldByHand();
        boolean changed = held != seen;
        if (held == LEFT_RIGHT && changed) {
            screen.showNextLayer(nowNanos);
        }
        secondLook = !secondLook;
        if (held == DOWN_ENTER && secondLook) {
            if (changed) {
                seen = held;
                endProgram.run();
            }
        } else if (held != DOWN_ENTER) {
            seen = held;
        }
    }
}
