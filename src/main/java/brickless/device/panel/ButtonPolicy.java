package brickless.device.panel;

import brickless.device.panel.PanelListener.KeyOrigin;
import java.util.OptionalLong;
import java.util.function.BooleanSupplier;

/**
 * Presses keys for a program that waits for one while nobody is there: a wait that has lasted a second gets a press of
 * 200 ms; repeated waits cycle ENTER, RIGHT, LEFT, DOWN, UP, never ESCAPE. Guarded by the simulation's thread: only
 * {@link #step} touches it.
 */
public final class ButtonPolicy {
    /** How long a wait must last before it is answered, in nanoseconds. */
    public static final long PATIENCE_NANOS = 1_000_000_000;
    /** Length of an automatic press in nanoseconds. */
    public static final long PRESS_NANOS = 200_000_000;

    /** Looks so much earlier than it must: a live clock and the simulation's time are not quite the same. */
    private static final long AHEAD_NANOS = 100_000_000;

    private static final int[] CYCLE = {2, 8, 16, 4, 1};
    private static final int NOTHING = 0;

    private final KeyPad keys;
    private final BooleanSupplier keyPressesScheduled;
    private int presses;
    private int holding = NOTHING;
    private long releaseAtNanos;
    private long nextLookNanos;

    /**
     * Watches a key pad.
     *
     * @param keyPressesScheduled whether somebody else is still going to press a key; while so the policy keeps still
     */
    public ButtonPolicy(KeyPad keys, BooleanSupplier keyPressesScheduled) {
        this.keys = keys;
        this.keyPressesScheduled = keyPressesScheduled;
    }

    /** Presses or releases a key if it is time to; called at each physics step with the present time. */
    public void step(long nowNanos) {
        if (nowNanos < nextLookNanos) {
            return;
        }
        look(nowNanos);
        nextLookNanos = holding == NOTHING ? keys.waitingEarliest(nowNanos) + PATIENCE_NANOS - AHEAD_NANOS : releaseAtNanos;
    }

    /** Until this time nothing happens, and {@link #step} need not be called. */
    public long nextLookNanos() {
        return nextLookNanos;
    }

    private void look(long nowNanos) {
        if (holding != NOTHING) {
            if (nowNanos >= releaseAtNanos) {
                keys.hold(holding, false, KeyOrigin.POLICY);
                holding = NOTHING;
            }
            return;
        }
        OptionalLong since = keys.waitingSince();
        if (since.isPresent() && nowNanos - since.getAsLong() >= PATIENCE_NANOS
                && !keyPressesScheduled.getAsBoolean()) {
            holding = CYCLE[presses++ % CYCLE.length];
            releaseAtNanos = nowNanos + PRESS_NANOS;
            keys.hold(holding, true, KeyOrigin.POLICY);
        }
    }

    /** Number of automatic presses so far. */
    public int presses() {
        return presses;
    }
}
