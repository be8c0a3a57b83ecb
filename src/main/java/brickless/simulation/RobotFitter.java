package brickless.simulation;

import brickless.loading.hints.HardwareHints;
import brickless.world.DescriptionException;
import brickless.world.RobotModel;
import brickless.world.SensorType;
import brickless.world.svg.SvgRobotReader;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * Fits a robot to a program: driven wheels, tyres, track and sensors as the program's bytecode expects them, in the
 * usual places.
 *
 * <p>The result is an ordinary robot file, so that it can be kept and edited.
 */
final class RobotFitter {
    /** Sensors by the leJOS class that reads them. */
    static final Map<String, SensorType> SENSORS = Map.ofEntries(
            Map.entry("EV3TouchSensor", SensorType.EV3_TOUCH), Map.entry("EV3ColorSensor", SensorType.EV3_COLOR),
            Map.entry("EV3UltrasonicSensor", SensorType.EV3_ULTRASONIC),
            Map.entry("EV3GyroSensor", SensorType.EV3_GYRO), Map.entry("EV3IRSensor", SensorType.EV3_INFRARED),
            Map.entry("NXTTouchSensor", SensorType.NXT_TOUCH), Map.entry("NXTLightSensor", SensorType.NXT_LIGHT),
            Map.entry("NXTSoundSensor", SensorType.NXT_SOUND), Map.entry("NXTColorSensor", SensorType.NXT_COLOR),
            Map.entry("NXTUltrasonicSensor", SensorType.NXT_ULTRASONIC),
            Map.entry("RCXLightSensor", SensorType.NXT_LIGHT));

    private RobotFitter() {}

    /** The robot for a program with these hints, named after the file in which it is kept. */
    static RobotModel fit(HardwareHints hints) {
        String drawing = draw(hints);
        try {
            return SvgRobotReader.readText(FinishedRun.robotFile(0, ""), drawing);
        } catch (DescriptionException e) {
            throw new IllegalStateException("the fitted robot must be readable:\n" + drawing, e);
        }
    }

    /**
     * The usual mount of a sensor that a program opens at a port, 0 to 3; of a driver of its own the usual one of its
     * kind.
     */
    static RobotModel.SensorMount mount(String lejosClass, int port) {
        HardwareHints only = new HardwareHints(List.of(),
                List.of(new HardwareHints.Device("S" + (port + 1), lejosClass, "")), List.of());
        return fit(only).sensors().get(0);
    }

    /** One line about the fitted robot for the summary. */
    static String describe(RobotModel robot) {
        List<String> parts = new ArrayList<>();
        robot.wheels().forEach(wheel -> parts.add(describe(wheel)));
        if (robot.wheels().size() == 2) {
            double track = Math.abs(robot.wheels().get(0).position().y() - robot.wheels().get(1).position().y());
            parts.add(String.format(Locale.ROOT, "track %.0f mm", track * 1000));
        }
        robot.turrets()
                .forEach(tool -> parts.add(tool.motor().attribute() + " motor on " + (char) ('A' + tool.port())));
        robot.sensors().forEach(sensor ->
                parts.add(sensor.type().attribute() + " on S" + (sensor.port() + 1) + direction(sensor)));
        return "robot fitted to the program: " + String.join(", ", parts);
    }

    private static String describe(RobotModel.Wheel wheel) {
        String side = wheel.omni() ? "omni" : wheel.position().y() < 0 ? "left" : "right";
        return String.format(Locale.ROOT, "%s wheel on %c (%s motor%s, %.1f mm%s)", side, (char) ('A' + wheel.port()),
                wheel.motor().attribute(), wheel.inverted() ? " reversed" : "", wheel.diameterMetres() * 1000,
                wheel.gearRatio() == 1 ? "" : String.format(Locale.ROOT, ", gear %.2f", wheel.gearRatio()));
    }

    private static String direction(RobotModel.SensorMount sensor) {
        double quarters = sensor.headingRadians() / (StrictMath.PI / 2);
        return Math.abs(quarters) < 0.5 ? "" : Math.abs(quarters) > 1.5 ? " (behind)" : quarters < 0 ? " (to the left)"
                : " (to the right)";
    }

    private static String draw(HardwareHints hints) {
        ChassisDrawing chassis = ChassisDrawing.of(hints);
        List<String> elements = new ArrayList<>(chassis.elements());
        elements.addAll(chassis.tools(hints));
        elements.addAll(new SensorLayout(hints.sensors(), chassis.front(), chassis.halfWidth()).elements());
        return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-180 -160 360 320\">\n  "
                + String.join("\n  ", elements) + "\n</svg>\n";
    }

    /** The sensor kind for a device of a program, if it is one that can be simulated. */
    static Optional<SensorType> sensorOf(HardwareHints.Device device) {
        return sensorOf(device.lejosClass()).or(() -> OwnDriver.sensorOf(device));
    }

    /** The sensor kind a leJOS class reads, if it is one that can be simulated. */
    static Optional<SensorType> sensorOf(String lejosClass) {
        return Optional.ofNullable(SENSORS.get(lejosClass));
    }
}
