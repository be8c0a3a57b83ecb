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
 * Fits a robot to a program: driven wheels, tyres, track and sensors as the program's bytecode expects them, in the usual places.
 *
 * <p>The result is an ordinary robot file, so that it can be kept and edited.
 */
final class RobotFitter {
    /** Sensors by the leJOS class that reads them. */
    static final Map<String, SensorType> SENSORS = Map.ofEntries(
            Map.entry("EV3TouchSensor", SensorType.EV3_TOUCH), Map.entry("EV3ColorSensor", SensorType.EV3_COLOR),
            Map.entry("EV3UltrasonicSensor", SensorType.EV3_ULTRASONIC), Map.entry("EV3GyroSensor", SensorType.EV3_GYRO),
            Map.entry("EV3IRSensor", SensorType.EV3_INFRARED), Map.entry("NXTTouchSensor", SensorType.NXT_TOUCH),
            Map.entry("NXTLightSensor", SensorType.NXT_LIGHT), Map.entry("NXTSoundSensor", SensorType.NXT_SOUND),
            Map.entry("NXTColorSensor", SensorType.NXT_COLOR), Map.entry("NXTUltrasonicSensor", SensorType.NXT_ULTRASONIC),
            Map.entry("RCXLightSensor", SensorType.NXT_LIGHT));

    private final DriveFit drive;
    private final HardwareHints hints;
    private final StringBuilder svg = new StringBuilder();

    private RobotFitter(HardwareHints hints) {
        this.hints = hints;
        drive = DriveFit.of(hints);
    }

    /** The robot for a program with these hints. */
    static RobotModel fit(HardwareHints hints) {
        String drawing = new RobotFitter(hints).draw();
        try {
            return SvgRobotReader.readText("auto.svg", drawing);
        } catch (DescriptionException e) {
            throw new IllegalStateException("the fitted robot must be readable:\n" + drawing, e);
        }
    }

    /** The usual mount of a sensor that a program opens at a port, 0 to 3. */
    static RobotModel.SensorMount mount(String lejosClass, int port) {
        HardwareHints only = new HardwareHints(List.of(), List.of(new HardwareHints.Device("S" + (port + 1), lejosClass, "")), List.of());
        return fit(only).sensors().get(0);
    }

    /** One line about the fitted robot for the summary. */
    static String describe(RobotModel robot) {
        StringBuilder text = new StringBuilder("robot fitted to the program: ");
        List<String> parts = new ArrayList<>();
        for (RobotModel.Wheel wheel : robot.wheels()) {
            parts.add(String.format(Locale.ROOT, "%s wheel on %c (%s motor, %.1f mm)", wheel.position().y() < 0 ? "left" : "right",
                    (char) ('A' + wheel.port()), wheel.motor().attribute(), wheel.diameterMetres() * 1000));
        }
        if (robot.wheels().size() == 2) {
            double track = Math.abs(robot.wheels().get(0).position().y() - robot.wheels().get(1).position().y());
            parts.add(String.format(Locale.ROOT, "track %.0f mm", track * 1000));
        }
        robot.sensors().forEach(sensor -> parts.add(sensor.type().attribute() + " on S" + (sensor.port() + 1)));
        return text.append(String.join(", ", parts)).toString();
    }

    private String draw() {
        double half = drive.trackMillimetres() / 2;
        double width = Math.max(70, drive.trackMillimetres() - 34);
        svg.append("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-180 -160 360 320\">\n");
        line("<rect data-part=\"chassis\" id=\"body\" x=\"-105\" y=\"%.1f\" width=\"200\" height=\"%.1f\" rx=\"8\" data-mass-kg=\"0.75\" "
                + "fill=\"#e8eaed\" stroke=\"#5f6368\" stroke-width=\"2\"/>", -width / 2, width);
        line("<rect x=\"-62\" y=\"-36\" width=\"112\" height=\"72\" rx=\"6\" fill=\"#9aa0a6\"/>");
        line("<rect x=\"-10\" y=\"-24\" width=\"46\" height=\"48\" fill=\"#cfd8c7\"/>");
        line("<circle data-part=\"caster\" id=\"caster\" cx=\"-82\" cy=\"0\" r=\"8\" fill=\"#3c4043\"/>");
        wheel("left-wheel", drive.leftPort(), drive.leftMotor(), -half);
        wheel("right-wheel", drive.rightPort(), drive.rightMotor(), half);
        new SensorLayout(hints.sensors()).elements().forEach(this::line);
        return svg.append("</svg>\n").toString();
    }

    private void wheel(String id, String port, String motor, double y) {
        double diameter = drive.diameterMillimetres();
        line("<rect data-part=\"wheel\" id=\"%s\" x=\"%.2f\" y=\"%.2f\" width=\"%.2f\" height=\"22\" rx=\"4\" fill=\"#202124\" data-port=\"%s\" "
                + "data-motor=\"%s\" data-diameter-mm=\"%.2f\"%s/>", id, -diameter / 2, y - 11, diameter, port, motor, diameter,
                drive.gearRatio() == 1 ? "" : String.format(Locale.ROOT, " data-gear-ratio=\"%.4f\"", drive.gearRatio()));
    }

    private void line(String format, Object... values) {
        svg.append("  ").append(values.length == 0 ? format : String.format(Locale.ROOT, format, values)).append('\n');
    }

    /** The sensor kind a leJOS class reads, if it is one that can be simulated. */
    static Optional<SensorType> sensorOf(String lejosClass) {
        return Optional.ofNullable(SENSORS.get(lejosClass));
    }
}
