package brickless.trace;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** The named signals of one sample. */
final class SignalRow {
    private final Map<String, String> values = new LinkedHashMap<>();

    SignalRow(Sample sample) {
        values.put("time_s", Decimals.seconds(sample.timeNanos()));
        boolean several = sample.robots().size() > 1;
        for (RobotSample robot : sample.robots()) {
            add(several ? robot.name() + "." : "", robot);
        }
    }

    private void add(String prefix, RobotSample robot) {
        put(prefix + "x_m", robot.pose().x(), 5);
        put(prefix + "y_m", robot.pose().y(), 5);
        put(prefix + "heading_deg", StrictMath.toDegrees(robot.pose().headingRadians()), 3);
        for (RobotSample.MotorSample motor : robot.motors()) {
            put(prefix + motor.port() + "_tacho_deg", motor.tachoDegrees(), 2);
            put(prefix + motor.port() + "_speed_dps", motor.degreesPerSecond(), 1);
            put(prefix + motor.port() + "_duty_pct", motor.dutyPercent(), 1);
            put(prefix + motor.port() + "_current_a", motor.amperes(), 3);
        }
        for (RobotSample.SensorSample sensor : robot.sensors()) {
            String name = prefix + "S" + sensor.port() + "_" + sensor.kind();
            values.put(name, "");
            for (int i = 0; i < sensor.values().length; i++) {
                put(name + (i > 0 ? "_" + i : ""), sensor.values()[i], 4);
            }
        }
        put(prefix + "battery_v", robot.batteryVolts(), 3);
    }

    private void put(String name, double value, int places) {
        values.put(name, Double.isFinite(value) ? Decimals.text(value, places) : Double.isNaN(value) ? ""
                : value > 0 ? "inf" : "-inf");
    }

    List<String> names() {
        return List.copyOf(values.keySet());
    }

    String text(Collection<String> columns) {
        return columns.stream().map(column -> values.getOrDefault(column, "")).collect(Collectors.joining(","));
    }
}
