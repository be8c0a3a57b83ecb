package brickless.trace;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;

/**
 * Writes the canonical trace, line by line, and hashes it.
 *
 * <p>The hash is SHA-256 over exactly the bytes of {@code trace.jsonl}, so {@code sha256sum trace.jsonl} gives it again. Not thread-safe:
 * the simulation writes from one thread at a time.
 */
public final class TraceWriter implements AutoCloseable {
    private final OutputStream out;
    private final MessageDigest digest;
    private String hash;

    /** Creates a writer and writes the header line. */
    public TraceWriter(OutputStream out, TraceHeader header) {
        this.out = out;
        try {
            digest = MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every JDK has SHA-256", e);
        }
        append(JsonText.object(line -> header.write(line.text("type", "header"))));
    }

    /** Writes an event of one robot. */
    public void event(long timeNanos, String robot, TraceEvent event) {
        append(JsonText.object(line -> {
            line.seconds("t", timeNanos).text("type", event.type()).text("robot", robot);
            event.write(line);
        }));
    }

    /** Writes a sample. */
    public void sample(Sample sample) {
        append(JsonText.object(line -> {
            line.seconds("t", sample.timeNanos()).text("type", "sample");
            line.objects("robots", sample.robots(), TraceWriter::robot);
            if (!sample.bodies().isEmpty()) {
                line.objects("bodies", sample.bodies(), (body, fields) -> pose(fields.text("id", body.id()), body.displacement()));
            }
        }));
    }

    private static void robot(RobotSample robot, JsonLine line) {
        pose(line.text("name", robot.name()), robot.pose());
        line.objects("motors", robot.motors(), (motor, fields) -> fields.text("port", String.valueOf(motor.port()))
                .number("tacho", motor.tachoDegrees(), 2).number("speed", motor.degreesPerSecond(), 1)
                .number("duty", motor.dutyPercent(), 1).number("amperes", motor.amperes(), 3));
        line.objects("sensors", robot.sensors(), (sensor, fields) -> fields.integer("port", sensor.port()).text("kind", sensor.kind())
                .numbers("values", sensor.values(), 4));
        line.number("volts", robot.batteryVolts(), 3);
    }

    private static JsonLine pose(JsonLine line, brickless.world.Pose2 pose) {
        return line.number("x", pose.x(), 5).number("y", pose.y(), 5).number("heading", StrictMath.toDegrees(pose.headingRadians()), 3);
    }

    private void append(String line) {
        byte[] bytes = (line + "\n").getBytes(StandardCharsets.UTF_8);
        digest.update(bytes);
        try {
            out.write(bytes);
        } catch (IOException e) {
            throw new UncheckedIOException("cannot write the trace", e);
        }
    }

    /** SHA-256 of everything written, in hexadecimal; nothing may be written afterwards. */
    public String hash() {
        if (hash == null) {
            hash = HexFormat.of().formatHex(digest.digest());
        }
        return hash;
    }

    @Override public void close() throws IOException {
        out.close();
    }
}
