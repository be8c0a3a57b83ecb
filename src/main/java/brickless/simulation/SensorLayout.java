package brickless.simulation;

import brickless.loading.hints.HardwareHints;
import brickless.world.SensorType;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * The usual places of sensors on a fitted robot. A second one of a kind sits beside the first, unless the names of both
 * tell where they are: distance sensors then look to their side.
 */
final class SensorLayout {
    /** Distance from the axle to the front of the usual chassis in millimetres. */
    static final double USUAL_FRONT = 95;

    private final List<String> elements = new ArrayList<>();
    private final Map<SensorType, Integer> ahead = new EnumMap<>(SensorType.class);
    private final Map<SensorType, Integer> placed = new EnumMap<>(SensorType.class);
    private final double front;
    private final double halfWidth;

    /**
     * Lays sensors out.
     *
     * @param front distance from the robot's origin to the front of its chassis in millimetres
     * @param halfWidth distance from its middle to its sides
     */
    SensorLayout(List<HardwareHints.Device> sensors, double front, double halfWidth) {
        this.front = front;
        this.halfWidth = halfWidth;
        sensors.forEach(sensor -> RobotFitter.sensorOf(sensor).ifPresent(type -> count(type, Side.of(sensor.name()))));
        sensors.forEach(sensor -> RobotFitter.sensorOf(sensor)
                .ifPresent(type -> place(type, sensor.port(), Side.of(sensor.name()))));
    }

    /** SVG elements, one per sensor. */
    List<String> elements() {
        return elements;
    }

    private void count(SensorType type, Side side) {
        if (!isDistance(type) || side == Side.UNKNOWN) {
            ahead.merge(type, 1, Integer::sum);
        }
    }

    private static boolean isDistance(SensorType type) {
        return type == SensorType.EV3_ULTRASONIC || type == SensorType.NXT_ULTRASONIC
                || type == SensorType.EV3_INFRARED;
    }

    private void place(SensorType type, String port, Side side) {
        if (isDistance(type) && side != Side.UNKNOWN) {
            distance(type, port, side == Side.REAR ? new Spot(-95, 0, 180)
                    : new Spot(front - 37, side == Side.LEFT ? -halfWidth : halfWidth, side == Side.LEFT ? -90 : 90));
            return;
        }
        double beside = beside(type, side);
        switch (type) {
            case EV3_TOUCH, NXT_TOUCH -> {
                Spot spot = side == Side.REAR ? new Spot(-113, 0, 180) : new Spot(front + 8, 32 * beside, 0);
                double width = beside == 0 || side == Side.REAR ? 2 * halfWidth + 26 : 54;
                add(type, port, spot, 10, width, 40, "#c62828");
            }
            case EV3_COLOR, NXT_COLOR, NXT_LIGHT ->
                    add(type, port, new Spot(front - 23, 20 * beside, 0), 16, 16, 8, "#1565c0");
            case EV3_ULTRASONIC, NXT_ULTRASONIC, EV3_INFRARED ->
                    distance(type, port, new Spot(front - 11, 34 * beside, 0));
            case EV3_GYRO -> add(type, port, new Spot(0, 24 * beside, 0), 18, 18, 60, "#6a1b9a");
            default -> add(type, port, new Spot(30, 30 * beside, 0), 16, 16, 70, "#8d6e63");
        }
    }

    /** −1 on the left, 1 on the right, 0 for the only one of its kind. */
    private double beside(SensorType type, Side side) {
        int index = placed.merge(type, 1, Integer::sum) - 1;
        if (ahead.get(type) == 1) {
            return 0;
        }
        return side == Side.LEFT ? -1 : side == Side.RIGHT ? 1 : index % 2 == 0 ? -1 : 1;
    }

    private void distance(SensorType type, String port, Spot spot) {
        boolean infrared = type == SensorType.EV3_INFRARED;
        add(type, port, spot, 20, infrared ? 40 : 52, infrared ? 75 : 90, infrared ? "#263238" : "#455a64");
    }

    /** Middle of a sensor in millimetres and where it looks, clockwise from ahead. */
    private record Spot(double x, double y, double headingDegrees) {}

    private void add(SensorType type, String port, Spot spot, double length, double width, double height,
            String colour) {
        String transform = spot.headingDegrees == 0 ? ""
                : String.format(Locale.ROOT, " transform=\"rotate(%.0f %.1f %.1f)\"", spot.headingDegrees,
                        spot.x, spot.y);
        elements.add(String.format(Locale.ROOT,
                "<rect data-part=\"sensor\" id=\"%s-%s\" x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" "
                + "data-port=\"%s\" data-sensor=\"%s\" data-height-mm=\"%.0f\" fill=\"%s\"%s/>", type.attribute(),
                port.toLowerCase(Locale.ROOT), spot.x - length / 2, spot.y - width / 2, length, width, port,
                type.attribute(), height, colour, transform));
    }
}
