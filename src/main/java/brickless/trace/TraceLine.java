package brickless.trace;

import brickless.world.Pose2;

/** The lines of a trace as text, without the line end. The trace itself gets its samples from {@link SampleLine}, which is faster. */
public final class TraceLine {
    private TraceLine() {}

    /** The line of an event of one robot. */
    public static String event(long timeNanos, String robot, TraceEvent event) {
        return JsonText.object(line -> {
            line.seconds("t", timeNanos).text("type", event.type()).text("robot", robot);
            event.write(line);
        });
    }

    /** The line of a sample. */
    public static String sample(Sample sample) {
        return JsonText.object(line -> {
            line.seconds("t", sample.timeNanos()).text("type", "sample");
            line.objects("robots", sample.robots(), TraceLine::robot);
            if (!sample.bodies().isEmpty()) {
                line.objects("bodies", sample.bodies(), (body, fields) -> pose(fields.text("id", body.id()), body.displacement()));
            }
        });
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

    /** Writes a pose as everywhere in the trace: metres, and degrees clockwise. */
    public static JsonLine pose(JsonLine line, Pose2 pose) {
        return line.number("x", pose.x(), 5).number("y", pose.y(), 5).number("heading", StrictMath.toDegrees(pose.headingRadians()), 3);
    }
}
