package brickless.device.panel;

import brickless.hardware.SpeakerSocket;
import brickless.kernel.Processor;

/** The loudspeaker: it reports every sound and knows until when one is playing; a new sound replaces the old one. */
public final class Speaker implements SpeakerSocket {
    private static final long NANOS_PER_MILLI = 1_000_000;

    private final Processor processor;
    private final PanelListener listener;
    private long busyUntilNanos;

    /** A silent loudspeaker. */
    public Speaker(Processor processor, PanelListener listener) {
        this.processor = processor;
        this.listener = listener;
    }

    @Override
    public void tone(int frequencyHertz, int durationMillis, int volumePercent) {
        processor.charge(PanelCharges.SOUND_NANOS);
        long now = processor.nowNanos();
        start(now, durationMillis);
        listener.toneStarted(now, frequencyHertz, durationMillis, volumePercent);
    }

    @Override
    public void sample(String name, int durationMillis, int volumePercent) {
        processor.charge(PanelCharges.SOUND_NANOS);
        long now = processor.nowNanos();
        start(now, durationMillis);
        listener.sampleStarted(now, name, durationMillis, volumePercent);
    }

    @Override
    public void silence() {
        processor.charge(PanelCharges.SOUND_NANOS);
        long now = processor.nowNanos();
        if (playing(now)) {
            start(now, 0);
            listener.soundStopped(now);
        }
    }

    /** Whether something is sounding at the given time. */
    public synchronized boolean playing(long nowNanos) {
        return nowNanos < busyUntilNanos;
    }

    private synchronized void start(long nowNanos, int durationMillis) {
        busyUntilNanos = nowNanos + durationMillis * NANOS_PER_MILLI;
    }
}
