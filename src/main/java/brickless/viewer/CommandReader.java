package brickless.viewer;

import brickless.trace.JsonFields;
import java.util.OptionalLong;

/** Reads commands from the bodies of requests. */
final class CommandReader {
    private static final long MILLI = 1_000_000;
    private static final long USUAL_STEP_MILLIS = 50;
    private static final long LONGEST_STEP_MILLIS = 60_000;

    private CommandReader() {}

    /**
     * The command of one JSON object.
     *
     * @throws RefusedException if it is none; the message says what is allowed
     */
    static Command read(String body) {
        try {
            return command(JsonFields.parse(body));
        } catch (IllegalArgumentException e) {
            throw new RefusedException(e.getMessage());
        }
    }

    private static Command command(JsonFields fields) {
        String name = fields.text("do");
        return switch (name) {
            case "pause" -> new Command.Pause();
            case "play" -> new Command.Play();
            case "step" -> new Command.Step(MILLI * (fields.has("millis")
                    ? between(1, LONGEST_STEP_MILLIS, "millis", fields) : USUAL_STEP_MILLIS));
            case "speed" -> new Command.SetSpeed(speed(fields));
            case "restart" -> new Command.Restart(fields.has("seed")
                    ? OptionalLong.of(fields.integer("seed")) : OptionalLong.empty());
            case "touch" -> new Command.Touch(fields.text("stimulus"));
            case "hold" -> new Command.Hold(fields.has("robot") ? fields.text("robot") : "", fields.text("what"),
                    fields.flag("down"), fields.has("viewer")
                    ? (int) between(0, Integer.MAX_VALUE, "viewer", fields) : 0);
            default -> throw new IllegalArgumentException("'" + name
                    + "' is nothing to do; allowed: pause, play, step, speed, restart, touch, hold");
        };
    }

    private static double speed(JsonFields fields) {
        double speed = fields.isText("value") ? Speed.parse(fields.text("value")).orElse(Double.NaN)
                : fields.number("value");
        return Speed.check(speed);
    }

    private static long between(long least, long most, String name, JsonFields fields) {
        long value = fields.integer(name);
        if (value < least || value > most) {
            throw new IllegalArgumentException("field \"" + name + "\" is " + least + " to " + most);
        }
        return value;
    }
}
