package brickless.trace;

import brickless.world.Pose2;
import com.fasterxml.jackson.core.io.JsonStringEncoder;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The trace's line of one sample. Samples are most of a trace, so their text is put together by hand, in one buffer
 * that is used again and again; {@code SampleLineTest} holds it against an ordinary JSON writer.
 */
final class SampleLine {
    private final Map<String, byte[]> texts = new HashMap<>();
    private byte[] buffer = new byte[1 << 12];
    private int size;

    /** The line with its line feed, in the array from 0 to the limit, valid until the next call. */
    ByteBuffer write(Sample sample) {
        size = 0;
        raw("{\"t\":").scaled(sample.timeNanos() / 1_000, 6).raw(",\"type\":\"sample\",\"robots\":[");
        List<RobotSample> robots = sample.robots();
        for (int i = 0; i < robots.size(); i++) {
            raw(i == 0 ? "{" : ",{").robot(robots.get(i));
        }
        raw("]");
        if (!sample.bodies().isEmpty()) {
            bodies(sample.bodies());
        }
        raw("}\n");
        return ByteBuffer.wrap(buffer, 0, size);
    }

    private void bodies(List<BodySample> bodies) {
        raw(",\"bodies\":[");
        for (int i = 0; i < bodies.size(); i++) {
            raw(i == 0 ? "{\"id\":" : ",{\"id\":").text(bodies.get(i).id()).pose(bodies.get(i).displacement()).raw("}");
        }
        raw("]");
    }

    private void robot(RobotSample robot) {
        raw("\"name\":").text(robot.name()).pose(robot.pose()).raw(",\"motors\":[");
        for (int i = 0; i < robot.motors().size(); i++) {
            raw(i == 0 ? "{" : ",{").motor(robot.motors().get(i));
        }
        raw("],\"sensors\":[");
        for (int i = 0; i < robot.sensors().size(); i++) {
            raw(i == 0 ? "{" : ",{").sensor(robot.sensors().get(i));
        }
        raw("],\"volts\":").number(robot.batteryVolts(), 3).raw("}");
    }

    private void motor(RobotSample.MotorSample motor) {
        raw("\"port\":").text(String.valueOf(motor.port())).raw(",\"tacho\":").number(motor.tachoDegrees(), 2)
                .raw(",\"speed\":")
                .number(motor.degreesPerSecond(), 1).raw(",\"duty\":").number(motor.dutyPercent(), 1)
                .raw(",\"amperes\":").number(motor.amperes(), 3).raw("}");
    }

    private void sensor(RobotSample.SensorSample sensor) {
        raw("\"port\":").scaled(sensor.port(), 0).raw(",\"kind\":").text(sensor.kind()).raw(",\"values\":[");
        double[] values = sensor.values();
        for (int i = 0; i < values.length; i++) {
            raw(i == 0 ? "" : ",").number(values[i], 4);
        }
        raw("]}");
    }

    private SampleLine pose(Pose2 pose) {
        return raw(",\"x\":").number(pose.x(), 5).raw(",\"y\":").number(pose.y(), 5).raw(",\"heading\":")
                .number(StrictMath.toDegrees(pose.headingRadians()), 3);
    }

    private SampleLine number(double value, int places) {
        return Double.isFinite(value) ? scaled(Decimals.rounded(value, places), places) : raw("null");
    }

    private SampleLine scaled(long value, int places) {
        reserve(Decimals.MOST_BYTES);
        size = Decimals.put(value, places, buffer, size);
        return this;
    }

    /** A string in quotes. */
    private SampleLine text(String value) {
        byte[] quoted = texts.get(value);
        if (quoted == null) {
            quoted = ('"' + new String(JsonStringEncoder.getInstance().quoteAsString(value)) + '"')
                    .getBytes(StandardCharsets.UTF_8);
            texts.put(value, quoted);
        }
        reserve(quoted.length);
        System.arraycopy(quoted, 0, buffer, size, quoted.length);
        size += quoted.length;
        return this;
    }

    @SuppressWarnings("deprecation") // copies the low bytes of characters, which is what ASCII is
    private SampleLine raw(String ascii) {
        reserve(ascii.length());
        ascii.getBytes(0, ascii.length(), buffer, size);
        size += ascii.length();
        return this;
    }

    private void reserve(int bytes) {
        if (size + bytes > buffer.length) {
            buffer = Arrays.copyOf(buffer, Math.max(2 * buffer.length, size + bytes));
        }
    }
}
