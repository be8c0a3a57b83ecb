package brickless.trace;

import brickless.world.Pose2;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/**
 * The lines of a trace as text, without the line end. The trace itself gets its samples from {@link SampleLine}, which
 * is faster.
 */
public final class TraceLine {
    private TraceLine() {}

    /** The line of an event of one robot. */
    public static String event(long timeNanos, String robot, TraceEvent event) {
        return JsonText.object(line -> {
            line.seconds("t", timeNanos).text("type", event.type()).text("robot", robot);
            event.write(line);
        });
    }

    /** The line of a sample. */
    public static String sample(Sample sample) {
        ByteBuffer line = new SampleLine().write(sample);
        return new String(line.array(), 0, line.limit() - 1, StandardCharsets.UTF_8);
    }

    /** Writes a pose as everywhere in the trace: metres, and degrees clockwise. */
    public static JsonLine pose(JsonLine line, Pose2 pose) {
        return line.number("x", pose.x(), 5).number("y", pose.y(), 5)
                .number("heading", StrictMath.toDegrees(pose.headingRadians()), 3);
    }
}
