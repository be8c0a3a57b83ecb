package brickless.device.panel;

import brickless.device.panel.PanelListener.KeyOrigin;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;

/**
 * Presses keys for a program while nobody is there: a wait for a key that has lasted a second gets a press of 200 ms,
 * and so does a program that has been asking for a key for three seconds in which no motor turned, as in {@code while
 * (Button.ENTER.isUp())}. Repeated presses cycle ENTER, RIGHT, LEFT, DOWN, UP, of the keys asked for; never ESCAPE.
 * Guarded by the simulation's thread: only {@link #step} touches it.
 */
public final class ButtonPolicy {
    /** How long a wait must last before it is answered, in nanoseconds. */
    public static final long PATIENCE_NANOS = 1_000_000_000;
    /**
     * Each wait is answered so much later than the one before, in nanoseconds: of two threads that look every 50 ms not
     * always the same one sees the press first.
     */
    public static final long LATER_NANOS = 7_000_000;
    /** How long a program must ask for a key, and its motors rest, before it is pressed, in nanoseconds. Assumption. */
    public static final long ASKED_PATIENCE_NANOS = 3_000_000_000L;
    /** Length of an automatic press in nanoseconds; a key that was asked for is held until the program looks again. */
    public static final long PRESS_NANOS = 200_000_000;
    /** Longest press in nanoseconds, if the program does not look again. Assumption. */
    public static final long LONGEST_PRESS_NANOS = 5_000_000_000L;

    private static final int[] CYCLE = {2, 8, 16, 4, 1};
    private static final int NOTHING = 0;
    private static final long NEVER = Long.MAX_VALUE;
    /** leJOS looks twice, 10 ms apart: so long a key is still held after the program has looked. Assumption. */
    private static final long DEBOUNCE_NANOS = 50_000_000;
    /** After so many presses the delays begin anew: the eighth is one of 49 ms. */
    private static final int PERIOD = 8;

    private final KeyPad keys;
    private final Circumstances around;
    private final List<Integer> presses = new ArrayList<>();
    private int next;
    private int holding = NOTHING;
    private boolean holdingForQuestion;
    private long pressedAtNanos;
    private long lookedAtNanos;
    private long lastTurnedNanos;

    /** What happens around the keys. */
    public interface Circumstances {
        /** Whether somebody else is still going to press a key; while so the policy keeps still. */
        boolean keyPressesToCome();

        /** Whether anything else is still going to be done to the robot; while so the policy only answers waits. */
        boolean stimuliToCome();

        /** Whether no motor turns or is driven. */
        boolean motorsRest();
    }

    /** Watches a key pad. */
    public ButtonPolicy(KeyPad keys, Circumstances around) {
        this.keys = keys;
        this.around = around;
    }

    /** Presses or releases a key if it is time to; called at each physics step with the present time. */
    public void step(long nowNanos) {
        if (!around.motorsRest()) {
            lastTurnedNanos = nowNanos;
        }
        if (holding != NOTHING) {
            release(nowNanos);
        } else if (waited(nowNanos) && !around.keyPressesToCome()) {
            press(KeyPad.ALL_KEYS, false, nowNanos);
        } else if (nowNanos - lastTurnedNanos >= ASKED_PATIENCE_NANOS && !around.stimuliToCome()) {
            press(keys.questions().askedFor(ASKED_PATIENCE_NANOS, nowNanos), true, nowNanos);
        }
    }

    private boolean waited(long nowNanos) {
        OptionalLong since = keys.waitingSince();
        long patience = PATIENCE_NANOS + presses.size() % PERIOD * LATER_NANOS;
        return since.isPresent() && nowNanos - since.getAsLong() >= patience;
    }

    /** Presses the next key of the cycle that is wanted, if one is. */
    private void press(int wanted, boolean forQuestion, long nowNanos) {
        for (int i = 0; i < CYCLE.length; i++) {
            int key = CYCLE[(next + i) % CYCLE.length];
            if ((wanted & key) != 0) {
                next += i + 1;
                presses.add(key);
                holding = key;
                holdingForQuestion = forQuestion;
                pressedAtNanos = nowNanos;
                lookedAtNanos = NEVER;
                keys.hold(key, true, KeyOrigin.POLICY);
                return;
            }
        }
    }

    private void release(long nowNanos) {
        long held = nowNanos - pressedAtNanos;
        if (lookedAtNanos == NEVER && keys.questions().askedAfter(holding, pressedAtNanos)) {
            lookedAtNanos = nowNanos;
        }
        boolean noticed = !holdingForQuestion || nowNanos - lookedAtNanos >= DEBOUNCE_NANOS;
        if (held >= PRESS_NANOS && noticed || held >= LONGEST_PRESS_NANOS) {
            keys.hold(holding, false, KeyOrigin.POLICY);
            holding = NOTHING;
        }
    }

    /** Keys pressed so far, in order. */
    public List<Integer> presses() {
        return List.copyOf(presses);
    }
}
