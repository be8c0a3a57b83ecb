package brickless.trace;

import java.util.List;

/** Something that happened at one instant of a run, other than the regular samples. */
public sealed interface TraceEvent {
    /** Name of the event in the trace. */
    String type();

    /** Writes the event's own fields. */
    void write(JsonLine line);

    /** A key went down or up; {@code cause} is {@code stimulus}, {@code auto} or {@code program}. */
    record KeyEvent(String key, boolean down, String cause) implements TraceEvent {
        @Override
        public String type() {
            return "key";
        }

        @Override
        public void write(JsonLine line) {
            line.text("key", key).flag("down", down).text("cause", cause);
        }
    }

    /** The LED pattern changed. */
    record LedEvent(int pattern) implements TraceEvent {
        @Override
        public String type() {
            return "led";
        }

        @Override
        public void write(JsonLine line) {
            line.integer("pattern", pattern);
        }
    }

    /** A sound started: a tone, or a named sample with {@code frequencyHertz} 0. */
    record SoundEvent(String name, int frequencyHertz, int durationMillis, int volumePercent) implements TraceEvent {
        @Override
        public String type() {
            return "sound";
        }

        @Override
        public void write(JsonLine line) {
            line.text("name", name).integer("hertz", frequencyHertz).integer("millis", durationMillis)
                    .integer("volume", volumePercent);
        }
    }

    /** Rows of the screen changed: row numbers, and per row its 23 bytes in hexadecimal, leftmost byte first. */
    record ScreenEvent(List<Integer> rows, List<String> pixels) implements TraceEvent {
        public ScreenEvent {
            rows = List.copyOf(rows);
            pixels = List.copyOf(pixels);
        }

        @Override
        public String type() {
            return "screen";
        }

        @Override
        public void write(JsonLine line) {
            line.integers("rows", rows).texts("pixels", pixels);
        }
    }

    /** The program printed text. */
    record PrintEvent(String text, boolean error) implements TraceEvent {
        @Override
        public String type() {
            return "print";
        }

        @Override
        public void write(JsonLine line) {
            line.text("text", text).flag("error", error);
        }
    }

    /** An arbitrator was created with these behaviours, lowest priority first. */
    record ArbitratorEvent(int arbitrator, List<String> behaviours) implements TraceEvent {
        public ArbitratorEvent {
            behaviours = List.copyOf(behaviours);
        }

        @Override
        public String type() {
            return "arbitrator";
        }

        @Override
        public void write(JsonLine line) {
            line.integer("arbitrator", arbitrator).texts("behaviours", behaviours);
        }
    }

    /**
     * An arbitrator's state changed; {@code change} is {@code wants}, {@code active} or {@code suppressed}; behaviour
     * −1 = none.
     */
    record BehaviourEvent(String change, int arbitrator, int behaviour) implements TraceEvent {
        @Override
        public String type() {
            return change;
        }

        @Override
        public void write(JsonLine line) {
            line.integer("arbitrator", arbitrator).integer("behaviour", behaviour);
        }
    }

    /** From here on samples have a sensor's values in this mode; port 1 to 4, LEGO's name of the mode. */
    record ModeEvent(int port, String kind, String mode) implements TraceEvent {
        @Override
        public String type() {
            return "mode";
        }

        @Override
        public void write(JsonLine line) {
            line.integer("port", port).text("kind", kind).text("mode", mode);
        }
    }

    /**
     * The robot and something else touched after having been apart; speed in metres per second at which they closed in.
     */
    record CollisionEvent(String other, double speed) implements TraceEvent {
        @Override
        public String type() {
            return "collision";
        }

        @Override
        public void write(JsonLine line) {
            line.text("with", other).number("speed", speed, 3);
        }
    }

    /** A wheel of the robot went over the edge of the table. */
    record FallEvent() implements TraceEvent {
        @Override
        public String type() {
            return "fell";
        }

        @Override
        public void write(JsonLine line) {
            line.flag("over", true);
        }
    }

    /** The robot's origin entered or left a zone. */
    record ZoneEvent(String zone, boolean entered) implements TraceEvent {
        @Override
        public String type() {
            return "zone";
        }

        @Override
        public void write(JsonLine line) {
            line.text("zone", zone).flag("entered", entered);
        }
    }

    /** A person or the world did something to the robot, in the words of the stimuli file. */
    record StimulusEvent(String text) implements TraceEvent {
        @Override
        public String type() {
            return "stimulus";
        }

        @Override
        public void write(JsonLine line) {
            line.text("do", text);
        }
    }

    /** A thread ended with an exception that the program did not handle. */
    record ExceptionEvent(String thread, String exception) implements TraceEvent {
        @Override
        public String type() {
            return "exception";
        }

        @Override
        public void write(JsonLine line) {
            line.text("thread", thread).text("exception", exception);
        }
    }

    /** The robot's program, or the run, ended. */
    record EndEvent(String outcome, int exitStatus) implements TraceEvent {
        @Override
        public String type() {
            return "end";
        }

        @Override
        public void write(JsonLine line) {
            line.text("outcome", outcome).integer("exitStatus", exitStatus);
        }
    }
}
