package brickless.viewer;

import brickless.simulation.Frame;
import brickless.simulation.RunReport;
import brickless.trace.JsonLine;
import brickless.trace.JsonText;
import brickless.trace.Sample;
import brickless.trace.TraceLine;
import brickless.world.Point2;
import brickless.world.Rgb;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/** The messages to viewers as server-sent events. LIVE-VIEW.md lists their fields. */
final class Messages {
    private Messages() {}

    /** Everything so far, for a viewer that begins. */
    static byte[] begin(Session session, int viewer) {
        return message("begin", line -> {
            line.integer("session", session.number()).integer("viewer", viewer);
            line.object("scene", () -> session.run().scene().write(line));
            line.object("header", () -> session.tap().header().write(line));
            line.object("recording", () -> session.tap().recording().write(line));
            line.text("program", session.prepared().program().name()).text("world", session.tap().header().world())
                    .text("robot", session.tap().header().robots().get(0));
            Duration limit = session.prepared().settings().limit();
            if (limit.toNanos() == Long.MAX_VALUE) {
                line.nothing("limit");
            } else {
                line.seconds("limit", limit.toNanos());
            }
            line.integer("seed", session.prepared().settings().seed())
                    .flag("attended", session.prepared().settings().attended());
        });
    }

    /** A line of the trace. */
    static byte[] sample(Sample sample) {
        return bytes("sample", TraceLine.sample(sample));
    }

    /** Lines of the trace. */
    static byte[] events(List<String> lines) {
        return bytes("events", "{\"events\":[" + String.join(",", lines) + "]}");
    }

    static byte[] frame(Frame frame) {
        return message("frame", line -> {
            line.seconds("t", frame.timeNanos());
            line.objects("robots", frame.robots(), Messages::robot);
            line.objects("bodies", frame.bodies(), (body, fields) ->
                    TraceLine.pose(fields.text("id", body.id()), body.displacement()));
        });
    }

    private static void robot(Frame.RobotFrame robot, JsonLine line) {
        TraceLine.pose(line.text("name", robot.name()), robot.pose());
        line.objects("parts", robot.parts(), (part, fields) -> fields.text("id", part.id())
                .text("port", String.valueOf(part.port()))
                .number("degrees", StrictMath.toDegrees(part.angleRadians()), 2));
        line.objects("beams", robot.beams(), (beam, fields) -> fields.integer("port", beam.port())
                .text("kind", beam.kind()).raw("from", point(beam.from()))
                .raw("rays", "[" + String.join(",", beam.ends().stream().map(Messages::point).toList()) + "]")
                .number("metres", beam.metres(), 3));
        line.objects("spots", robot.spots(), (spot, fields) -> fields.integer("port", spot.port())
                .text("kind", spot.kind()).raw("at", point(spot.at())).number("radius", spot.radiusMetres(), 4)
                .raw("rgb", spot.colour().map(Messages::colour).orElse("null")));
    }

    private static String point(Point2 point) {
        return JsonText.pair(point.x(), point.y(), 4);
    }

    private static String colour(Rgb colour) {
        return "[" + colour.red() + "," + colour.green() + "," + colour.blue() + "]";
    }

    /**
     * How the run stands.
     *
     * @param running whether time passes
     * @param speed wanted simulated seconds per second
     * @param rate the same as it is
     * @param changed files that changed since the start
     * @param message something to be told to people
     */
    static byte[] state(Session session, boolean running, double speed, double rate, List<Path> changed,
            Optional<String> message) {
        return message("state", line -> {
            line.seconds("t", session.nowNanos()).integer("session", session.number()).flag("running", running);
            if (speed == Speed.MAX) {
                line.text("speed", "max");
            } else {
                line.number("speed", speed, 3);
            }
            line.number("rate", rate, 2);
            Optional<RunReport> report = session.report();
            if (report.isPresent()) {
                line.object("ended", () -> ended(report.get(), line));
            } else {
                line.nothing("ended");
            }
            line.integer("touches", session.touches()).texts("changed", changed.stream().map(Path::toString).toList());
            textOrNothing(line, "message", message);
        });
    }

    private static void ended(RunReport report, JsonLine line) {
        line.text("outcome", report.outcome().kind());
        if (report.outcome().exitStatus().isPresent()) {
            line.integer("exitStatus", report.outcome().exitStatus().get());
        } else {
            line.nothing("exitStatus");
        }
        textOrNothing(line, "error", report.outcome().error());
        line.text("hash", report.traceHash());
    }

    private static void textOrNothing(JsonLine line, String name, Optional<String> value) {
        if (value.isPresent()) {
            line.text(name, value.get());
        } else {
            line.nothing(name);
        }
    }

    private static byte[] message(String name, Consumer<JsonLine> fields) {
        return bytes(name, JsonText.object(fields));
    }

    private static byte[] bytes(String name, String json) {
        return ("event: " + name + "\ndata: " + json + "\n\n").getBytes(StandardCharsets.UTF_8);
    }
}
