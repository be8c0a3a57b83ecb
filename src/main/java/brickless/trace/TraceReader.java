package brickless.trace;

import brickless.world.Pose2;
import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.security.DigestInputStream;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;

/**
 * Reads {@code trace.jsonl} back, line by line.
 *
 * <p>Times come back in whole microseconds, numbers as they were rounded; written again they give the same bytes and
 * the same hash.
 */
public final class TraceReader {
    private final String file;
    private final TraceListener listener;
    private long line;
    private boolean ended;

    private TraceReader(String file, TraceListener listener) {
        this.file = file;
        this.listener = listener;
    }

    /**
     * Reads a whole trace.
     *
     * @param file the trace
     * @param listener is told everything in order
     * @return SHA-256 of the file in hexadecimal: the hash of the run
     * @throws TraceException located, if the file is missing, cut off, damaged, or of a version this program does not
     *         know
     */
    public static String read(Path file, TraceListener listener) throws TraceException {
        try (InputStream in = Files.newInputStream(file)) {
            return read(file.toString(), in, listener);
        } catch (NoSuchFileException e) {
            throw new TraceException(file.toString(), 0, "no such file");
        } catch (IOException e) {
            throw new TraceException(file.toString(), 0, "cannot be read: " + e.getMessage());
        }
    }

    /** Reads a whole trace from a stream; {@code name} stands for it in messages. */
    public static String read(String name, InputStream in, TraceListener listener) throws TraceException, IOException {
        TraceReader reader = new TraceReader(name, listener);
        MessageDigest digest = sha256();
        reader.lines(new BufferedInputStream(new DigestInputStream(in, digest), 1 << 16));
        return HexFormat.of().formatHex(digest.digest());
    }

    private static MessageDigest sha256() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every JDK has SHA-256", e);
        }
    }

    private void lines(InputStream in) throws IOException, TraceException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        for (int next = in.read(); next >= 0; next = in.read()) {
            if (next == '\n') {
                line++;
                line(bytes.toString(StandardCharsets.UTF_8));
                bytes.reset();
            } else {
                bytes.write(next);
            }
        }
        if (bytes.size() > 0) {
            throw new TraceException(file, line + 1, "cut off in the middle of a line");
        }
        if (!ended) {
            throw new TraceException(file, line, line == 0 ? "empty"
                    : "cut off: the last line does not tell the end of the run");
        }
    }

    private void line(String text) throws TraceException {
        try {
            JsonFields fields = JsonFields.parse(text);
            String type = fields.text("type");
            if (line == 1) {
                listener.header(header(type, fields));
            } else if (ended) {
                throw new IllegalArgumentException("goes on after the end of the run");
            } else if (type.equals("sample")) {
                listener.sample(sample(fields));
            } else {
                TraceEvent event = EventReader.read(type, fields);
                ended = event instanceof TraceEvent.EndEvent;
                listener.event(fields.nanos("t"), fields.text("robot"), event);
            }
        } catch (IllegalArgumentException | ArithmeticException e) {
            throw new TraceException(file, line, e.getMessage());
        }
    }

    private static TraceHeader header(String type, JsonFields fields) {
        if (!type.equals("header")) {
            throw new IllegalArgumentException("is no trace: the first line is no header");
        }
        long version = fields.integer("version");
        if (version != TraceHeader.VERSION) {
            throw new IllegalArgumentException("trace version " + version + " is not known; this program reads version "
                    + TraceHeader.VERSION);
        }
        return new TraceHeader(fields.text("main"), fields.text("world"), fields.texts("robots"),
                fields.integer("seed"), fields.integer("scheduleSeed"), fields.flag("ideal"), fields.nanos("step"),
                fields.nanos("sample"));
    }

    private static Sample sample(JsonFields fields) {
        List<RobotSample> robots = fields.objects("robots").stream().map(TraceReader::robot).toList();
        List<BodySample> bodies = fields.objects("bodies").stream()
                .map(body -> new BodySample(body.text("id"), pose(body))).toList();
        return new Sample(fields.nanos("t"), robots, bodies);
    }

    private static RobotSample robot(JsonFields robot) {
        List<RobotSample.MotorSample> motors = new ArrayList<>();
        for (JsonFields motor : robot.objects("motors")) {
            motors.add(new RobotSample.MotorSample(port(motor), motor.number("tacho"), motor.number("speed"),
                    motor.number("duty"), motor.number("amperes")));
        }
        List<RobotSample.SensorSample> sensors = new ArrayList<>();
        for (JsonFields sensor : robot.objects("sensors")) {
            sensors.add(new RobotSample.SensorSample((int) sensor.integer("port"), sensor.text("kind"),
                    sensor.numbers("values")));
        }
        return new RobotSample(robot.text("name"), pose(robot), motors, sensors, robot.number("volts"));
    }

    private static char port(JsonFields motor) {
        String port = motor.text("port");
        if (!port.matches("[A-D]")) {
            throw new IllegalArgumentException("field \"port\" is no motor port");
        }
        return port.charAt(0);
    }

    private static Pose2 pose(JsonFields fields) {
        return new Pose2(fields.number("x"), fields.number("y"), StrictMath.toRadians(fields.number("heading")));
    }
}
