package brickless.simulation;

import brickless.device.panel.ButtonPolicy;
import brickless.device.panel.KeyChords;
import brickless.device.panel.KeyPad;
import brickless.device.panel.LedPanel;
import brickless.device.panel.PanelListener;
import brickless.device.panel.ScreenPanel;
import brickless.device.panel.Speaker;
import brickless.hardware.ScreenSocket;
import brickless.kernel.Processor;
import brickless.trace.TraceEvent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The front of one robot's brick: screen, keys, LEDs and loudspeaker, and what of it goes into the trace. */
final class Panel implements PanelListener {
    private final String robot;
    private final Recorder recorder;
    private final KeyPad keys;
    private final LedPanel leds;
    private final Speaker speaker;
    private final ScreenPanel screen;
    private final KeyChords chords;
    private final Optional<ButtonPolicy> policy;
    private long nextNanos;
    private byte[] shown = new byte[ScreenSocket.ROW_BYTES * ScreenSocket.HEIGHT];

    Panel(String robot, Processor processor, Recorder recorder, boolean pressKeys, ButtonPolicy.Circumstances around,
            Runnable endProgram) {
        this.robot = robot;
        this.recorder = recorder;
        keys = new KeyPad(processor, this);
        leds = new LedPanel(processor, this);
        speaker = new Speaker(processor, this);
        screen = new ScreenPanel(processor, this);
        chords = new KeyChords(keys, screen, endProgram);
        policy = pressKeys ? Optional.of(new ButtonPolicy(keys, around)) : Optional.empty();
    }

    KeyPad keys() {
        return keys;
    }

    LedPanel leds() {
        return leds;
    }

    Speaker speaker() {
        return speaker;
    }

    ScreenPanel screen() {
        return screen;
    }

    /** Names of the keys pressed for the program, in order. */
    List<String> automaticPresses() {
        return policy.map(ButtonPolicy::presses).orElse(List.of()).stream().map(Panel::nameOf).toList();
    }

    private static String nameOf(int key) {
        return StimuliReader.KEYS.entrySet().stream().filter(named -> named.getValue() == key).findFirst().orElseThrow()
                .getKey();
    }

    /** To be called at every physics step; most of the time nothing is due. */
    void step(long nowNanos) {
        if (nowNanos < nextNanos) {
            return;
        }
        nextNanos = Long.MAX_VALUE;
        if (policy.isPresent()) {
            policy.get().step(nowNanos);
            nextNanos = policy.get().nextLookNanos();
        }
        chords.step(nowNanos);
        screen.step(nowNanos);
        nextNanos = Math.min(nextNanos, Math.min(chords.nextLookNanos(), screen.nextRefreshNanos()));
    }

    @Override
    public void keysChanged(long nowNanos, int keyMask, boolean down, KeyOrigin origin) {
        String cause = switch (origin) {
            case HAND -> "stimulus";
            case POLICY -> "auto";
            case PROGRAM -> "program";
        };
        for (Map.Entry<String, Integer> key : StimuliReader.KEYS.entrySet()) {
            if ((keyMask & key.getValue()) != 0) {
                recorder.event(nowNanos, robot, new TraceEvent.KeyEvent(key.getKey(), down, cause));
            }
        }
    }

    @Override
    public void ledChanged(long nowNanos, int pattern) {
        recorder.event(nowNanos, robot, new TraceEvent.LedEvent(pattern));
    }

    @Override
    public void toneStarted(long nowNanos, int frequencyHertz, int durationMillis, int volumePercent) {
        recorder.event(nowNanos, robot,
                new TraceEvent.SoundEvent("tone", frequencyHertz, durationMillis, volumePercent));
    }

    @Override
    public void sampleStarted(long nowNanos, String name, int durationMillis, int volumePercent) {
        recorder.event(nowNanos, robot, new TraceEvent.SoundEvent(name, 0, durationMillis, volumePercent));
    }

    @Override
    public void soundStopped(long nowNanos) {
        recorder.event(nowNanos, robot, new TraceEvent.SoundEvent("silence", 0, 0, 0));
    }

    @Override
    public void screenChanged(long nowNanos) {
        byte[] now = screen.displayed();
        List<Integer> rows = new ArrayList<>();
        List<String> pixels = new ArrayList<>();
        for (int row = 0; row < ScreenSocket.HEIGHT; row++) {
            int from = row * ScreenSocket.ROW_BYTES;
            int to = from + ScreenSocket.ROW_BYTES;
            if (!Arrays.equals(now, from, to, shown, from, to)) {
                rows.add(row);
                pixels.add(HexFormat.of().formatHex(now, from, to));
            }
        }
        shown = now;
        if (!rows.isEmpty()) {
            recorder.event(nowNanos, robot, new TraceEvent.ScreenEvent(rows, pixels));
        }
    }
}
