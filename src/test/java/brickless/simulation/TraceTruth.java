package brickless.simulation;

import brickless.trace.CollectedTrace;
import brickless.trace.RobotSample;
import brickless.trace.Sample;
import brickless.trace.TraceEvent;
import brickless.trace.TraceReader;
import java.nio.file.Path;
import java.util.HexFormat;
import java.util.List;

/** What a trace says about one moment, worked out from its lines alone. */
final class TraceTruth {
    private final CollectedTrace trace = new CollectedTrace();

    TraceTruth(Path folder) throws Exception {
        TraceReader.read(folder.resolve("trace.jsonl"), trace);
    }

    CollectedTrace trace() {
        return trace;
    }

    /** x, y in millimetres and heading in degrees at the time of a sample. */
    double[] pose(double seconds) {
        long nanos = Math.round(seconds * 1e9);
        RobotSample robot = trace.samples.stream().filter(sample -> sample.timeNanos() == nanos).map(Sample::robots)
                .findFirst().orElseThrow().get(0);
        return new double[] {robot.pose().x() * 1000, robot.pose().y() * 1000,
                Math.toDegrees(robot.pose().headingRadians())};
    }

    String pixels(double seconds) {
        byte[] picture = new byte[23 * 128];
        for (CollectedTrace.Happening happening : trace.events) {
            if (happening.event() instanceof TraceEvent.ScreenEvent screen && happening.timeNanos() <= seconds * 1e9) {
                for (int i = 0; i < screen.rows().size(); i++) {
                    System.arraycopy(HexFormat.of().parseHex(screen.pixels().get(i)), 0, picture,
                            screen.rows().get(i) * 23, 23);
                }
            }
        }
        StringBuilder text = new StringBuilder();
        for (int dot = 0; dot < 178 * 128; dot++) {
            int x = dot % 178;
            text.append((picture[dot / 178 * 23 + x / 8] >> x % 8 & 1) != 0 ? '#' : '.');
        }
        return text.toString();
    }

    List<String> activeBehaviours(double seconds) {
        List<String> names = List.of();
        int active = -1;
        for (CollectedTrace.Happening happening : trace.events) {
            if (happening.timeNanos() > seconds * 1e9) {
                break;
            }
            if (happening.event() instanceof TraceEvent.ArbitratorEvent arbitrator) {
                names = arbitrator.behaviours();
            } else if (happening.event() instanceof TraceEvent.BehaviourEvent behaviour
                    && behaviour.type().equals("active")) {
                active = behaviour.behaviour();
            }
        }
        return active < 0 ? List.of() : List.of(names.get(active).replaceFirst(".*\\.", ""));
    }
}
