package brickless.device.panel;

import brickless.device.FakeProcessor;
import brickless.hardware.BrickHardware;
import brickless.hardware.MotorSocket;
import brickless.hardware.MoveRequest;
import brickless.hardware.PowerSocket;
import brickless.hardware.ProgramLog;
import brickless.hardware.SensorSocket;
import brickless.kernel.Processor;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * A brick with a real panel, no ports, and a clock that a single test thread moves by charging, sleeping and waiting.
 */
public final class PanelBench implements BrickHardware {
    private static final long NANOS_PER_MILLI = 1_000_000;

    private final TreeMap<Long, Runnable> scheduled = new TreeMap<>();
    private final List<String> events = new ArrayList<>();
    private final FakeProcessor processor = new FakeProcessor(NANOS_PER_MILLI, this::step);
    private final PanelListener recorder = new EventRecorder(events);
    public final ScreenPanel screen = new ScreenPanel(processor, recorder);
    public final KeyPad keys = new KeyPad(processor, recorder);
    public final LedPanel leds = new LedPanel(processor, recorder);
    public final Speaker speaker = new Speaker(processor, recorder);
    public final RecordedLog log = new RecordedLog();
    private float volts = 8;

    /** Does something at a time in milliseconds. */
    public PanelBench at(long millis, Runnable action) {
        scheduled.merge(millis * NANOS_PER_MILLI, action, (first, second) -> () -> {
            first.run();
            second.run();
        });
        return this;
    }

    /** Presses keys by hand for a while. */
    public PanelBench pressAt(long millis, int mask, long lengthMillis) {
        return at(millis, () -> keys.press(mask)).at(millis + lengthMillis, () -> keys.release(mask));
    }

    private void step(long nowNanos) {
        screen.step(nowNanos);
        while (!scheduled.isEmpty() && scheduled.firstKey() <= nowNanos) {
            Map.Entry<Long, Runnable> next = scheduled.pollFirstEntry();
            next.getValue().run();
        }
    }

    /** The clock. */
    public Processor processor() {
        return processor;
    }

    /** Present time in milliseconds. */
    public double millis() {
        return (double) processor.nowNanos() / NANOS_PER_MILLI;
    }

    /** What the panel reported, without time, e.g. {@code "tone 600 Hz 200 ms 80 %"}. */
    public List<String> events() {
        return events;
    }

    /** Sets the battery's voltage. */
    public void setVolts(float volts) {
        this.volts = volts;
    }

    @Override
    public String name() {
        return "bench";
    }

    @Override
    public MotorSocket motor(int index) {
        throw new UnsupportedOperationException("the panel bench has no ports");
    }

    @Override
    public SensorSocket sensor(int index) {
        throw new UnsupportedOperationException("the panel bench has no ports");
    }

    @Override
    public void moveTogether(int[] ports, MoveRequest[] requests) {
        throw new UnsupportedOperationException("the panel bench has no ports");
    }

    @Override
    public ScreenPanel screen() {
        return screen;
    }

    @Override
    public KeyPad keys() {
        return keys;
    }

    @Override
    public LedPanel leds() {
        return leds;
    }

    @Override
    public Speaker speaker() {
        return speaker;
    }

    @Override
    public PowerSocket power() {
        return new PowerSocket() {
            @Override
            public float voltageVolts() {
                return volts;
            }

            @Override
            public float batteryCurrentAmperes() {
                return 0.5f;
            }

            @Override
            public float motorCurrentAmperes() {
                return 0.25f;
            }
        };
    }

    @Override
    public ProgramLog log() {
        return log;
    }

    /** Remembers what the program printed and which exceptions nobody caught. */
    public static final class RecordedLog implements ProgramLog {
        private final ByteArrayOutputStream out = new ByteArrayOutputStream();
        private final ByteArrayOutputStream err = new ByteArrayOutputStream();
        private final List<Throwable> uncaught = new ArrayList<>();

        public String out() {
            return out.toString(StandardCharsets.UTF_8);
        }

        public String err() {
            return err.toString(StandardCharsets.UTF_8);
        }

        public List<Throwable> uncaught() {
            return uncaught;
        }

        @Override
        public void printed(byte[] bytes, int offset, int length, boolean error) {
            (error ? err : out).write(bytes, offset, length);
        }

        @Override
        public void uncaught(Thread thread, Throwable failure) {
            uncaught.add(failure);
        }

        @Override
        public int arbitratorCreated(String[] behaviours) {
            return 0;
        }

        @Override
        public void behaviourWanted(int arbitrator, int behaviour) {}

        @Override
        public void behaviourActive(int arbitrator, int behaviour) {}

        @Override
        public void behaviourSuppressed(int arbitrator, int behaviour) {}

        @Override
        public void endProgram(int status) {}
    }
}
