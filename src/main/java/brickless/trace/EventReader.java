package brickless.trace;

/** Reads events back from the fields of their lines. */
final class EventReader {
    private EventReader() {}

    /**
     * The event of one line.
     *
     * @throws IllegalArgumentException if the type is unknown or a field is missing or of another type
     */
    static TraceEvent read(String type, JsonFields line) {
        return switch (type) {
            case "key" -> new TraceEvent.KeyEvent(line.text("key"), line.flag("down"), line.text("cause"));
            case "led" -> new TraceEvent.LedEvent(small(line, "pattern"));
            case "sound" -> new TraceEvent.SoundEvent(line.text("name"), small(line, "hertz"), small(line, "millis"),
                    small(line, "volume"));
            case "screen" -> screen(line);
            case "print" -> new TraceEvent.PrintEvent(line.text("text"), line.flag("error"));
            case "arbitrator" -> new TraceEvent.ArbitratorEvent(small(line, "arbitrator"), line.texts("behaviours"));
            case "wants", "active", "suppressed" -> new TraceEvent.BehaviourEvent(type, small(line, "arbitrator"),
                    small(line, "behaviour"));
            case "mode" -> new TraceEvent.ModeEvent(small(line, "port"), line.text("kind"), line.text("mode"));
            case "collision" -> new TraceEvent.CollisionEvent(line.text("with"), line.number("speed"));
            case "fell" -> new TraceEvent.FallEvent();
            case "zone" -> new TraceEvent.ZoneEvent(line.text("zone"), line.flag("entered"));
            case "stimulus" -> new TraceEvent.StimulusEvent(line.text("do"));
            case "exception" -> new TraceEvent.ExceptionEvent(line.text("thread"), line.text("exception"));
            case "end" -> new TraceEvent.EndEvent(line.text("outcome"), small(line, "exitStatus"));
            default -> throw new IllegalArgumentException("unknown type \"" + type + "\"");
        };
    }

    private static TraceEvent screen(JsonFields line) {
        TraceEvent.ScreenEvent event = new TraceEvent.ScreenEvent(line.integers("rows"), line.texts("pixels"));
        if (event.rows().size() != event.pixels().size()) {
            throw new IllegalArgumentException("fields \"rows\" and \"pixels\" differ in length");
        }
        return event;
    }

    private static int small(JsonFields line, String name) {
        long value = line.integer(name);
        if (value != (int) value) {
            throw new IllegalArgumentException("field \"" + name + "\" is out of range");
        }
        return (int) value;
    }
}
