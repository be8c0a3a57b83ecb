package brickless.device.panel;

import java.util.List;

/** Writes panel events down as text. */
final class EventRecorder implements PanelListener {
    private final List<String> events;

    EventRecorder(List<String> events) {
        this.events = events;
    }

    @Override
    public void keysChanged(long nowNanos, int keyMask, boolean down, KeyOrigin origin) {
        events.add("key " + keyMask + (down ? " down by " : " up by ") + origin);
    }

    @Override
    public void ledChanged(long nowNanos, int pattern) {
        events.add("led " + pattern);
    }

    @Override
    public void toneStarted(long nowNanos, int frequencyHertz, int durationMillis, int volumePercent) {
        events.add("tone " + frequencyHertz + " Hz " + durationMillis + " ms " + volumePercent + " %");
    }

    @Override
    public void sampleStarted(long nowNanos, String name, int durationMillis, int volumePercent) {
        events.add("sample " + name + " " + durationMillis + " ms " + volumePercent + " %");
    }

    @Override
    public void soundStopped(long nowNanos) {
        events.add("silence");
    }

    @Override
    public void screenChanged(long nowNanos) {
        events.add("screen");
    }
}
