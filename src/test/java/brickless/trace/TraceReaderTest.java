package brickless.trace;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import brickless.trace.RobotSample.MotorSample;
import brickless.trace.RobotSample.SensorSample;
import brickless.world.Pose2;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** What was written is read back, and a file that is no whole trace is refused with the line. */
class TraceReaderTest {
    private static final TraceHeader HEADER = new TraceHeader("demo.Main", "pen", List.of("educator", "sumo"),
            Long.MIN_VALUE, 17, true, 2_000_000, 50_000_000);
    private static final TraceEvent END = new TraceEvent.EndEvent("exited", 0);

    @TempDir Path folder;

    static List<TraceEvent> everyKindOfEvent() {
        return List.of(new TraceEvent.KeyEvent("ENTER", true, "auto"), new TraceEvent.LedEvent(9),
                new TraceEvent.SoundEvent("tone", 440, 200, 80),
                new TraceEvent.ScreenEvent(List.of(0, 127), List.of("00".repeat(23), "ff".repeat(23))),
                new TraceEvent.PrintEvent("\"quoted\" \\ tab\t newline\n \u2028 € </script> \u0000", true),
                new TraceEvent.ArbitratorEvent(1, List.of("a.Cruise", "a.Turn$1")),
                new TraceEvent.BehaviourEvent("wants", 1, -1), new TraceEvent.BehaviourEvent("active", 1, 0),
                new TraceEvent.BehaviourEvent("suppressed", 1, 1),
                new TraceEvent.ModeEvent(4, "ev3-ultrasonic", "US-DIST-CM"), new TraceEvent.CollisionEvent("crate",
                        0.125), new TraceEvent.FallEvent(), new TraceEvent.ZoneEvent("goal", false),
                new TraceEvent.StimulusEvent("move robot 500,300 90"),
                new TraceEvent.ExceptionEvent("Thread-1", "java.lang.Error: no"), END);
    }

    private static String written(TraceEvent... events) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        TraceWriter writer = new TraceWriter(bytes, HEADER);
        for (TraceEvent event : events) {
            writer.event(1_500_001_000L, "r", event);
        }
        return bytes.toString(StandardCharsets.UTF_8);
    }

    private static CollectedTrace read(String text) throws TraceException, IOException {
        CollectedTrace trace = new CollectedTrace();
        TraceReader.read("trace.jsonl", new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), trace);
        return trace;
    }

    @Test
    void theHeaderComesBack() throws Exception {
        assertThat(read(written(END)).header).isEqualTo(HEADER);
    }

    @ParameterizedTest
    @MethodSource("everyKindOfEvent")
    void anEventComesBack(TraceEvent event) throws Exception {
        String text = event == END ? written(END) : written(event, END);
        assertThat(read(text).events.get(0)).isEqualTo(new CollectedTrace.Happening(1_500_001_000L, "r", event));
    }

    @Test
    void aSampleComesBackAsItWasRounded() throws Exception {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        TraceWriter writer = new TraceWriter(bytes, HEADER);
        RobotSample robot = new RobotSample("r", new Pose2(0.123456, -2, 1),
                List.of(new MotorSample('B', 90.126, -360.04, 41.55, 0.1204)),
                List.of(new SensorSample(4, "ev3-ultrasonic", new double[] {Double.POSITIVE_INFINITY, 2.5}),
                        new SensorSample(1, "ev3-touch", new double[0])), 8.1);
        writer.sample(new Sample(50_000_000, List.of(robot), List.of(new BodySample("box", new Pose2(0.01, 0, 0)))));
        writer.event(60_000_000, "r", END);
        Sample sample = read(bytes.toString(StandardCharsets.UTF_8)).samples.get(0);
        RobotSample back = sample.robots().get(0);
        assertThat(sample.timeNanos()).isEqualTo(50_000_000);
        assertThat(back.pose().x()).isEqualTo(0.12346);
        assertThat(back.pose().headingRadians()).isCloseTo(1, within(1e-5));
        assertThat(back.motors()).containsExactly(new MotorSample('B', 90.13, -360, 41.6, 0.12));
        assertThat(back.sensors().get(0).values()).containsExactly(Double.NaN, 2.5);
        assertThat(back.sensors().get(1).values()).isEmpty();
        assertThat(sample.bodies()).containsExactly(new BodySample("box", new Pose2(0.01, 0, 0)));
    }

    @Test
    void writtenAgainItIsTheSameTraceWithTheSameHash() throws Exception {
        ByteArrayOutputStream first = new ByteArrayOutputStream();
        String hash = written(first);
        Rewriting again = new Rewriting();
        String read = TraceReader.read("trace", new ByteArrayInputStream(first.toByteArray()), again);
        assertThat(read).isEqualTo(hash);
        assertThat(again.bytes.toString(StandardCharsets.UTF_8)).isEqualTo(first.toString(StandardCharsets.UTF_8));
        assertThat(again.writer.hash()).isEqualTo(hash);
    }

    private static String written(ByteArrayOutputStream bytes) {
        Rewriting writing = new Rewriting();
        SyntheticRun.busy(writing, 20);
        bytes.writeBytes(writing.bytes.toByteArray());
        return writing.writer.hash();
    }

    /** Writes what it is told. */
    private static final class Rewriting implements TraceListener {
        private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        private TraceWriter writer;

        @Override
        public void header(TraceHeader header) {
            writer = new TraceWriter(bytes, header);
        }

        @Override
        public void sample(Sample sample) {
            writer.sample(sample);
        }

        @Override
        public void event(long timeNanos, String robot, TraceEvent event) {
            writer.event(timeNanos, robot, event);
        }
    }

    @Test
    void aTraceOfAnotherVersionIsRefused() {
        String text = written(END).replace("\"version\":1", "\"version\":2");
        assertThatThrownBy(() -> read(text)).isInstanceOf(TraceException.class)
                .hasMessage("trace.jsonl:1: trace version 2 is not known; this program reads version 1");
    }

    @Test
    void aTraceCutAnywhereIsRefusedWithTheLine() {
        String whole = written(new TraceEvent.LedEvent(1), new TraceEvent.PrintEvent("text", false), END);
        for (int length = 0; length < whole.length(); length++) {
            String cut = whole.substring(0, length);
            long lines = cut.chars().filter(c -> c == '\n').count();
            boolean atLineEnd = cut.isEmpty() || cut.endsWith("\n");
            assertThatThrownBy(() -> read(cut)).as("cut after %d characters", length).isInstanceOf(TraceException.class)
                    .hasMessageStartingWith(lines == 0 && atLineEnd
                            ? "trace.jsonl: empty" : "trace.jsonl:" + (atLineEnd ? lines : lines + 1) + ": cut off");
        }
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "{\"t\":1,\"type\":\"led\",\"robot\":\"r\"} | field \"pattern\" is missing",
        "{\"t\":1,\"type\":\"led\",\"robot\":\"r\",\"pattern\":\"x\"} | field \"pattern\" is not a whole number",
        "{\"t\":1,\"type\":\"led\",\"robot\":\"r\",\"pattern\":9999999999} | field \"pattern\" is out of range",
        "{\"t\":1,\"type\":\"dance\",\"robot\":\"r\"} | unknown type \"dance\"",
        "{\"t\":\"soon\",\"type\":\"fell\",\"robot\":\"r\"} | field \"t\" is not a number",
        "{\"t\":1,\"type\":\"screen\",\"robot\":\"r\",\"rows\":[1],\"pixels\":[]}"
            + " | fields \"rows\" and \"pixels\" differ in length",
        "{\"t\":1,\"type\":\"sample\",\"robots\":[{\"name\":\"r\",\"x\":0,\"y\":0,\"heading\":0,"
            + "\"motors\":[{\"port\":\"E\"}]}]} | field \"port\" is no motor port",
        "[] | is no JSON object",
        "{} {} | holds more than one JSON object"
    })
    void aDamagedLineIsRefusedWithItsNumber(String line, String problem) {
        String text = written() + line + "\n";
        assertThatThrownBy(() -> read(text)).isInstanceOf(TraceException.class).hasMessage("trace.jsonl:2: " + problem);
    }

    @Test
    void linesBehindTheEndAreRefused() {
        String text = written(END, new TraceEvent.LedEvent(1));
        assertThatThrownBy(() -> read(text)).hasMessage("trace.jsonl:3: goes on after the end of the run");
    }

    @Test
    void aFileThatIsNotThereIsNamed() {
        assertThatThrownBy(() -> TraceReader.read(folder.resolve("trace.jsonl"), new CollectedTrace()))
                .isInstanceOf(TraceException.class).hasMessageEndingWith("trace.jsonl: no such file");
    }
}
