package brickless.device.panel;

import brickless.hardware.LedSocket;
import brickless.kernel.Processor;

/** The two LEDs behind the keys: both show one of ten patterns. */
public final class LedPanel implements LedSocket {
    private static final int PATTERNS = 10;

    private final Processor processor;
    private final PanelListener listener;
    private int pattern;

    /** LEDs that are off. */
    public LedPanel(Processor processor, PanelListener listener) {
        this.processor = processor;
        this.listener = listener;
    }

    @Override
    public void setPattern(int newPattern) {
        processor.charge(PanelCharges.LED_NANOS);
        if (newPattern >= 0 && newPattern < PATTERNS) {
            show(newPattern, processor.nowNanos());
        }
    }

    /** Switches the LEDs off, as the brick's menu does when a program has ended. */
    public void switchOff() {
        show(0, processor.nowNanos());
    }

    /** The pattern shown now, 0 (off) to 9. */
    public synchronized int pattern() {
        return pattern;
    }

    private synchronized void show(int newPattern, long nowNanos) {
        if (newPattern != pattern) {
            pattern = newPattern;
            listener.ledChanged(nowNanos, newPattern);
        }
    }
}
