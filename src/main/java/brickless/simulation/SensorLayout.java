package brickless.simulation;

import brickless.loading.hints.HardwareHints;
import brickless.world.SensorType;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** The usual places of sensors on a fitted robot; a second one of a kind sits beside the first. */
final class SensorLayout {
    private final List<String> elements = new ArrayList<>();
    private final Map<SensorType, Integer> used = new EnumMap<>(SensorType.class);
    private final Map<SensorType, Integer> total = new EnumMap<>(SensorType.class);

    SensorLayout(List<HardwareHints.Device> sensors) {
        sensors.forEach(sensor -> RobotFitter.sensorOf(sensor.lejosClass()).ifPresent(type -> total.merge(type, 1, Integer::sum)));
        sensors.forEach(sensor -> RobotFitter.sensorOf(sensor.lejosClass()).ifPresent(type -> place(type, sensor.port())));
    }

    /** SVG elements, one per sensor. */
    List<String> elements() {
        return elements;
    }

    private void place(SensorType type, String port) {
        int index = used.merge(type, 1, Integer::sum) - 1;
        double side = total.get(type) == 1 ? 0 : index % 2 == 0 ? -1 : 1;
        switch (type) {
            case EV3_TOUCH, NXT_TOUCH -> add(type, port, 103, total.get(type) == 1 ? 0 : 32 * side, 10, total.get(type) == 1 ? 112 : 54, 40, "#c62828");
            case EV3_COLOR, NXT_COLOR, NXT_LIGHT -> add(type, port, 72, 14 * side, 16, 16, 8, "#1565c0");
            case EV3_ULTRASONIC, NXT_ULTRASONIC -> add(type, port, 84, total.get(type) == 1 ? 0 : 34 * side, 20, 52, 90, "#455a64");
            case EV3_INFRARED -> add(type, port, 84, total.get(type) == 1 ? 0 : 34 * side, 20, 40, 75, "#263238");
            case EV3_GYRO -> add(type, port, 0, 24 * side, 18, 18, 60, "#6a1b9a");
            default -> add(type, port, 30, 30 * side, 16, 16, 70, "#8d6e63");
        }
    }

    private void add(SensorType type, String port, double x, double y, double length, double width, double height, String colour) {
        elements.add(String.format(Locale.ROOT, "<rect data-part=\"sensor\" id=\"%s-%s\" x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" "
                + "data-port=\"%s\" data-sensor=\"%s\" data-height-mm=\"%.0f\" fill=\"%s\"/>", type.attribute(), port.toLowerCase(Locale.ROOT),
                x - length / 2, y - width / 2, length, width, port, type.attribute(), height, colour));
    }
}
