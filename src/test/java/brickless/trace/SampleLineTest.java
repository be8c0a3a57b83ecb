package brickless.trace;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.trace.RobotSample.MotorSample;
import brickless.trace.RobotSample.SensorSample;
import brickless.world.Pose2;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Lines of samples are what an ordinary JSON writer writes. */
class SampleLineTest {
    private static final List<String> NAMES = List.of("robot", "Zoë", "a \"quoted\" \\ name", "tab\tand\nline",
            "\u0001\u007f", "机器人", "\ud83e\udd16", "");

    private final SampleLine line = new SampleLine();

    private String written(Sample sample) {
        ByteBuffer bytes = line.write(sample);
        return new String(bytes.array(), 0, bytes.limit(), StandardCharsets.UTF_8);
    }

    /** The same with Jackson's generator. */
    private static String expected(Sample sample) {
        return TraceLine.sample(sample) + "\n";
    }

    private static double number(Random random) {
        return switch (random.nextInt(8)) {
            case 0 -> 0;
            case 1 -> -0.0;
            case 2 -> Double.NaN;
            case 3 -> Double.NEGATIVE_INFINITY;
            case 4 -> random.nextInt(1000) / 8.0;
            case 5 -> -random.nextInt(100);
            case 6 -> (random.nextDouble() - 0.5) * 1e-4;
            default -> (random.nextDouble() - 0.5) * 1e9;
        };
    }

    private static Sample random(Random random) {
        List<RobotSample> robots = new ArrayList<>();
        for (int i = random.nextInt(4); i >= 0; i--) {
            List<MotorSample> motors = new ArrayList<>();
            List<SensorSample> sensors = new ArrayList<>();
            for (int port = 0; port < random.nextInt(5); port++) {
                motors.add(new MotorSample((char) ('A' + port), number(random), number(random), number(random),
                        number(random)));
                double[] values = random.doubles(random.nextInt(4)).toArray();
                sensors.add(new SensorSample(port + 1, NAMES.get(random.nextInt(NAMES.size())), values));
            }
            robots.add(new RobotSample(NAMES.get(i), new Pose2(number(random), number(random), number(random)), motors,
                    sensors, number(random)));
        }
        List<BodySample> bodies = new ArrayList<>();
        for (int i = random.nextInt(4); i > 0; i--) {
            bodies.add(new BodySample(NAMES.get(random.nextInt(NAMES.size())),
                    new Pose2(number(random), number(random), number(random))));
        }
        return new Sample(random.nextInt(2_000_000_000) * 1_000L, robots, bodies);
    }

    @Test
    void oneSampleByHand() {
        Sample sample = new Sample(1_050_000_000L, List.of(new RobotSample("robot", new Pose2(0.5, -1.25, 0),
                List.of(new MotorSample('B', 90, -0.06, 100, 0.1234)),
                List.of(new SensorSample(4, "ev3-ultrasonic", new double[] {255})), 8.2)), List.of());
        assertThat(written(sample)).isEqualTo(
                "{\"t\":1.05,\"type\":\"sample\",\"robots\":[{\"name\":\"robot\",\"x\":0.5,\"y\":-1.25,\"heading\":0,"
                + "\"motors\":[{\"port\":\"B\",\"tacho\":90,\"speed\":-0.1,\"duty\":100,\"amperes\":0.123}],"
                + "\"sensors\":[{\"port\":4,\"kind\":\"ev3-ultrasonic\",\"values\":[255]}],\"volts\":8.2}]}\n");
    }

    @Test
    void randomSamplesAreWhatAnOrdinaryWriterWrites() {
        for (int seed = 0; seed < 500; seed++) {
            Sample sample = random(new Random(seed));
            assertThat(written(sample)).as("seed %d", seed).isEqualTo(expected(sample));
        }
    }

    @Test
    void longLinesFindRoom() {
        List<BodySample> bodies = new ArrayList<>();
        for (int i = 0; i < 2_000; i++) {
            bodies.add(new BodySample("crate" + i, new Pose2(i / 7.0, -i / 3.0, i)));
        }
        Sample sample = new Sample(0, List.of(), bodies);
        assertThat(written(sample)).isEqualTo(expected(sample)).hasSizeGreaterThan(50_000);
    }
}
