package brickless.trace;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.world.Pose2;
import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.lang.reflect.RecordComponent;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** {@code sim/docs/TRACE.md} describes every line kind and every field that can be written, and no other. */
class TraceFormatTest {
    private static final List<String> CHANGES = List.of("wants", "active", "suppressed");

    @Test
    void theDescriptionIsComplete() throws IOException, ReflectiveOperationException {
        assertThat(described()).isEqualTo(written());
    }

    /** Fields by line kind, as the tables of the document list them. */
    private static Map<String, Set<String>> described() throws IOException {
        Map<String, Set<String>> kinds = new TreeMap<>();
        Set<String> fields = new TreeSet<>();
        boolean table = false;
        for (String line : Files.readAllLines(Path.of(System.getProperty("brickless.home"), "sim", "docs",
                "TRACE.md"))) {
            Matcher heading = Pattern.compile("## `(\\w+)`").matcher(line);
            Matcher row = Pattern.compile("\\| `([\\w.]+)` \\|.*").matcher(line);
            if (heading.matches()) {
                fields = kinds.computeIfAbsent(heading.group(1), kind -> new TreeSet<>());
            } else if (line.startsWith("| field")) {
                table = true;
            } else if (table && row.matches()) {
                assertThat(fields.add(row.group(1))).as(line).isTrue();
            } else if (!line.startsWith("|")) {
                table = false;
            }
        }
        return kinds;
    }

    private static Map<String, Set<String>> written() throws IOException, ReflectiveOperationException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        TraceWriter writer = new TraceWriter(out, new TraceHeader("Main", "pen", List.of("educator"), 1, -1, false,
                2_000_000, 50_000_000));
        Pose2 pose = new Pose2(1, 2, 3);
        RobotSample robot = new RobotSample("robot", pose, List.of(new RobotSample.MotorSample('A', 1, 2, 3, 4)),
                List.of(new RobotSample.SensorSample(1, "ev3-touch", new double[] {1})), 8);
        writer.sample(new Sample(0, List.of(robot), List.of(new BodySample("crate", pose))));
        for (TraceEvent event : everyEvent()) {
            writer.event(0, "robot", event);
        }
        Map<String, Set<String>> kinds = new TreeMap<>();
        for (String line : out.toString(StandardCharsets.UTF_8).split("\n")) {
            kinds.put(line.replaceFirst(".*?\"type\":\"(\\w+)\".*", "$1"), fields(line));
        }
        return kinds;
    }

    private static List<TraceEvent> everyEvent() throws ReflectiveOperationException {
        List<TraceEvent> events = new ArrayList<>();
        for (Class<?> type : TraceEvent.class.getPermittedSubclasses()) {
            if (type == TraceEvent.BehaviourEvent.class) {
                CHANGES.forEach(change -> events.add(new TraceEvent.BehaviourEvent(change, 0, 1)));
            } else {
                events.add((TraceEvent) instance(type));
            }
        }
        return events;
    }

    private static Object instance(Class<?> type) throws ReflectiveOperationException {
        Class<?>[] types = Arrays.stream(type.getRecordComponents()).map(RecordComponent::getType)
                .toArray(Class<?>[]::new);
        Object[] values = Arrays.stream(types).map(TraceFormatTest::anyValue).toArray();
        return type.getDeclaredConstructor(types).newInstance(values);
    }

    private static Object anyValue(Class<?> type) {
        if (type == boolean.class) {
            return true;
        }
        if (type == int.class) {
            return 1;
        }
        if (type == double.class) {
            return 1.0;
        }
        return type == List.class ? List.of() : "text";
    }

    /** Names of all fields of a JSON object, those of nested objects with the path to them. */
    private static Set<String> fields(String json) throws IOException {
        Set<String> fields = new TreeSet<>();
        List<String> path = new ArrayList<>();
        try (JsonParser parser = new JsonFactory().createParser(json)) {
            String last = "";
            for (JsonToken token = parser.nextToken(); token != null; token = parser.nextToken()) {
                if (token == JsonToken.START_OBJECT) {
                    path.add(last);
                } else if (token == JsonToken.END_OBJECT) {
                    path.remove(path.size() - 1);
                } else if (token == JsonToken.FIELD_NAME) {
                    last = path.get(path.size() - 1) + parser.currentName();
                    fields.add(last);
                    last += ".";
                }
            }
        }
        return fields;
    }
}
