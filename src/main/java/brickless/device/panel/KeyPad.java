package brickless.device.panel;

import brickless.device.panel.PanelListener.KeyOrigin;
import brickless.hardware.KeySocket;
import brickless.kernel.Processor;
import java.util.OptionalLong;

/** The six keys: what presses them from outside, and the program threads that wait for them. */
public final class KeyPad implements KeySocket {
    private final Processor processor;
    private final Processor.Signal changed;
    private final PanelListener listener;
    private final KeyWait programWait = new KeyWait();
    private final KeyQuestions questions = new KeyQuestions();
    private int held;
    private int simulated;
    private boolean attended;

    /** Keys that nobody presses. */
    public KeyPad(Processor processor, PanelListener listener) {
        this.processor = processor;
        this.changed = processor.newSignal();
        this.listener = listener;
    }

    @Override
    public int pressed(int asked) {
        processor.charge(PanelCharges.KEY_READ_NANOS);
        questions.ask(asked, processor.nowNanos());
        return state();
    }

    @Override
    public int awaitChange(int known, long timeoutNanos) throws InterruptedException {
        programWait.begin(processor.nowNanos());
        try {
            return blockWhile(known, timeoutNanos);
        } finally {
            programWait.end(processor.nowNanos());
        }
    }

    @Override
    public int awaitListenerEvent(int known) throws InterruptedException {
        return blockWhile(known, 0);
    }

    @Override
    public void simulate(int keyMask, boolean down) {
        processor.charge(PanelCharges.KEY_READ_NANOS);
        int before = state();
        synchronized (this) {
            simulated = down ? simulated | keyMask & ALL_KEYS : simulated & ~keyMask;
        }
        announce(before, KeyOrigin.PROGRAM);
    }

    @Override
    public synchronized boolean attended() {
        return attended;
    }

    /** Tells whether somebody watches the brick and can press keys; at first nobody does. */
    public synchronized void setAttended(boolean attended) {
        this.attended = attended;
    }

    /** Presses keys by hand; keys that are down already stay down. */
    public void press(int keyMask) {
        hold(keyMask, true, KeyOrigin.HAND);
    }

    /** Lets go of keys; keys that are up already stay up. */
    public void release(int keyMask) {
        hold(keyMask, false, KeyOrigin.HAND);
    }

    /** Keys that are down by hand, without those the program simulates. Costs the program nothing. */
    public synchronized int heldByHand() {
        return held;
    }

    /**
     * Since when a program thread has been doing nothing but wait for a key, in nanoseconds; empty if none waits. Key
     * changes start the count anew, and so does the program doing anything else between two waits; waiting key
     * listeners do not count.
     */
    public OptionalLong waitingSince() {
        return programWait.since();
    }

    /** {@link #waitingSince} will never tell an earlier time than this, whatever the program does from now on. */
    long waitingEarliest(long nowNanos) {
        return programWait.earliest(nowNanos);
    }

    /** What the program asks for when it looks at the keys without waiting. */
    KeyQuestions questions() {
        return questions;
    }

    void hold(int keyMask, boolean down, KeyOrigin origin) {
        int before = state();
        synchronized (this) {
            held = down ? held | keyMask & ALL_KEYS : held & ~keyMask;
        }
        announce(before, origin);
    }

    private synchronized int state() {
        return held | simulated;
    }

    private void announce(int before, KeyOrigin origin) {
        int after = state();
        if (after == before) {
            return;
        }
        long now = processor.nowNanos();
        programWait.restart(now);
        questions.restart(now);
        if ((after & ~before) != 0) {
            listener.keysChanged(now, after & ~before, true, origin);
        }
        if ((before & ~after) != 0) {
            listener.keysChanged(now, before & ~after, false, origin);
        }
        changed.raise();
    }

    private int blockWhile(int known, long timeoutNanos) throws InterruptedException {
        long deadline = processor.nowNanos() + timeoutNanos;
        processor.charge(PanelCharges.KEY_READ_NANOS);
        int now = state();
        while (now == known) {
            long left = timeoutNanos == 0 ? 0 : deadline - processor.nowNanos();
            if (left < 0 || timeoutNanos != 0 && left == 0 || !changed.awaitInterruptibly(left)) {
                return state();
            }
            now = state();
        }
        return now;
    }
}
