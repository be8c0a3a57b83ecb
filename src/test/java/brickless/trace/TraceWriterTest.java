package brickless.trace;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.world.Pose2;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.api.Test;

class TraceWriterTest {
    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private final TraceWriter writer = new TraceWriter(bytes,
            new TraceHeader("demo.Main", "pen", List.of("educator"), 7, -1, false, 2_000_000, 50_000_000));

    private List<String> lines() {
        return bytes.toString(StandardCharsets.UTF_8).lines().toList();
    }

    @Test
    void theFirstLineSaysWhatTheRunIsMadeOf() {
        assertThat(lines()).containsExactly(
                "{\"type\":\"header\",\"version\":1,\"main\":\"demo.Main\",\"world\":\"pen\",\"robots\":[\"educator\"],"
                + "\"seed\":7,\"scheduleSeed\":-1,\"ideal\":false,\"step\":0.002,\"sample\":0.05}");
    }

    @Test
    void aSampleIsOneLine() {
        RobotSample robot = new RobotSample("r", new Pose2(0.5, 0.25, StrictMath.PI / 2),
                List.of(new RobotSample.MotorSample('B', 90, 360, 41.5, 0.12)),
                List.of(new RobotSample.SensorSample(4, "ev3-ultrasonic", new double[] {255})), 8.15);
        writer.sample(new Sample(50_000_000, List.of(robot), List.of(new BodySample("box", new Pose2(0.01, 0, 0)))));
        assertThat(lines().get(1)).isEqualTo(
                "{\"t\":0.05,\"type\":\"sample\",\"robots\":[{\"name\":\"r\",\"x\":0.5,\"y\":0.25,\"heading\":90,"
                + "\"motors\":[{\"port\":\"B\",\"tacho\":90,\"speed\":360,\"duty\":41.5,\"amperes\":0.12}],"
                + "\"sensors\":[{\"port\":4,\"kind\":\"ev3-ultrasonic\",\"values\":[255]}],\"volts\":8.15}],"
                + "\"bodies\":[{\"id\":\"box\",\"x\":0.01,\"y\":0,\"heading\":0}]}");
    }

    @Test
    void eventsSayWhenWhoAndWhat() {
        writer.event(1_500_000_000L, "r", new TraceEvent.KeyEvent("ENTER", true, "auto"));
        assertThat(lines().get(1)).isEqualTo(
                "{\"t\":1.5,\"type\":\"key\",\"robot\":\"r\",\"key\":\"ENTER\",\"down\":true,\"cause\":\"auto\"}");
    }

    @Test
    void textIsEscaped() {
        writer.event(0, "r", new TraceEvent.PrintEvent("say \"hi\"\tthere", false));
        assertThat(lines().get(1)).contains("\"text\":\"say \\\"hi\\\"\\tthere\"");
    }

    @Test
    void theHashIsThatOfTheBytesWritten() throws IOException, GeneralSecurityException {
        writer.event(0, "r", new TraceEvent.LedEvent(4));
        writer.close();
        String expected = HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bytes.toByteArray()));
        assertThat(writer.hash()).isEqualTo(expected).isEqualTo(writer.hash());
    }
}
