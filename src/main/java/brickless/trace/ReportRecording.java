package brickless.trace;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Collects a run for its report: signals as columns, events in order. */
public final class ReportRecording implements TraceListener {
    private record Happening(long timeNanos, String robot, TraceEvent event) {}

    private record BodyColumns(Column x, Column y, Column heading) {}

    private final Column times = new Column(6);
    private final Map<String, RobotColumns> robots = new LinkedHashMap<>();
    private final Map<String, BodyColumns> bodies = new LinkedHashMap<>();
    private final List<Happening> events = new ArrayList<>();
    private TraceHeader header;
    private int samples;

    @Override
    public void header(TraceHeader value) {
        header = value;
    }

    @Override
    public void sample(Sample sample) {
        times.put(samples, sample.timeNanos() / 1_000 / 1e6);
        for (RobotSample robot : sample.robots()) {
            robots.computeIfAbsent(robot.name(), RobotColumns::new).add(samples, robot);
        }
        for (BodySample body : sample.bodies()) {
            BodyColumns columns = bodies.computeIfAbsent(body.id(),
                    id -> new BodyColumns(new Column(5), new Column(5), new Column(3)));
            columns.x().put(samples, body.displacement().x());
            columns.y().put(samples, body.displacement().y());
            columns.heading().put(samples, StrictMath.toDegrees(body.displacement().headingRadians()));
        }
        samples++;
    }

    @Override
    public void event(long timeNanos, String robot, TraceEvent event) {
        events.add(new Happening(timeNanos, robot, event));
    }

    /** Name of the program's main class. */
    String main() {
        return header.main();
    }

    /** Writes the fields of the recording: header, times, robots, bodies, events. */
    public void write(JsonLine line) {
        line.object("header", () -> header.write(line));
        line.raw("times", times.json());
        line.objects("robots", robots.values(), (robot, fields) -> robot.write(fields));
        line.objects("bodies", bodies.entrySet(), (body, fields) -> fields.text("id", body.getKey())
                .raw("x", body.getValue().x().json())
                .raw("y", body.getValue().y().json()).raw("heading", body.getValue().heading().json()));
        line.objects("events", events, (happening, fields) -> {
            fields.seconds("t", happening.timeNanos()).text("type", happening.event().type())
                    .text("robot", happening.robot());
            happening.event().write(fields);
        });
    }
}
