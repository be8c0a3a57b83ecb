package brickless.trace;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** The signals of one robot over a whole run, as columns. */
final class RobotColumns {
    private record Motor(Column tacho, Column speed, Column duty, Column amperes) {}

    private final String name;
    private final Column x = new Column(5);
    private final Column y = new Column(5);
    private final Column heading = new Column(3);
    private final Column volts = new Column(3);
    private final Map<Character, Motor> motors = new TreeMap<>();
    private final Map<String, List<Column>> sensors = new TreeMap<>();

    RobotColumns(String name) {
        this.name = name;
    }

    void add(int index, RobotSample sample) {
        x.put(index, sample.pose().x());
        y.put(index, sample.pose().y());
        heading.put(index, StrictMath.toDegrees(sample.pose().headingRadians()));
        volts.put(index, sample.batteryVolts());
        for (RobotSample.MotorSample motor : sample.motors()) {
            Motor columns = motors.computeIfAbsent(motor.port(),
                    port -> new Motor(new Column(2), new Column(1), new Column(1), new Column(3)));
            columns.tacho().put(index, motor.tachoDegrees());
            columns.speed().put(index, motor.degreesPerSecond());
            columns.duty().put(index, motor.dutyPercent());
            columns.amperes().put(index, motor.amperes());
        }
        for (RobotSample.SensorSample sensor : sample.sensors()) {
            List<Column> columns = sensors.computeIfAbsent(sensor.port() + sensor.kind(), key -> new ArrayList<>());
            for (int i = 0; i < sensor.values().length; i++) {
                if (i == columns.size()) {
                    columns.add(new Column(4));
                }
                columns.get(i).put(index, sensor.values()[i]);
            }
        }
    }

    void write(JsonLine line) {
        line.text("name", name).raw("x", x.json()).raw("y", y.json()).raw("heading", heading.json())
                .raw("volts", volts.json());
        line.objects("motors", motors.entrySet(), (motor, fields) -> fields.text("port", motor.getKey().toString())
                .raw("tacho", motor.getValue().tacho().json()).raw("speed", motor.getValue().speed().json())
                .raw("duty", motor.getValue().duty().json()).raw("amperes", motor.getValue().amperes().json()));
        line.objects("sensors", sensors.entrySet(), (sensor, fields) ->
                fields.integer("port", sensor.getKey().charAt(0) - '0').text("kind", sensor.getKey().substring(1))
                .raw("values", "[" + String.join(",", sensor.getValue().stream().map(Column::json).toList()) + "]"));
    }
}
