package brickless.simulation;

import brickless.loading.hints.HardwareHints;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Chassis, wheels and supports of a fitted robot.
 *
 * @param elements SVG elements
 * @param front distance from the robot's origin to the front of its chassis in millimetres
 * @param halfWidth distance from its middle to its sides in millimetres
 */
record ChassisDrawing(List<String> elements, double front, double halfWidth) {
    private static final double LENGTH = 200;
    private static final double USUAL_FRONT = 95;
    /** Omni wheels of a holonomic chassis: at least three decide all motions. */
    private static final int HOLONOMIC = 3;
    private static final double DEFAULT_RADIUS = 92;
    private static final double LEAST_RADIUS = 50;
    private static final double GREATEST_RADIUS = 300;
    private static final String BODY =
            "data-part=\"chassis\" id=\"body\" data-mass-kg=\"0.75\" fill=\"#e8eaed\" stroke=\"#5f6368\" "
                    + "stroke-width=\"2\"";

    /** The chassis for a program with these hints. */
    static ChassisDrawing of(HardwareHints hints) {
        return hints.omniWheels().size() >= HOLONOMIC ? holonomic(hints) : twoWheels(DriveFit.of(hints));
    }

    /** Motors that move no wheel: something is on their axle that a program does not tell. */
    List<String> tools(HardwareHints hints) {
        return hints.motors().stream()
                .filter(motor -> elements.stream().noneMatch(element -> element.contains(port(motor.port()))))
                .map(motor -> format("<g data-part=\"turret\" id=\"motor-%s\"%s data-motor=\"%s\"/>",
                        motor.port().toLowerCase(Locale.ROOT),
                        port(motor.port()), DriveFit.motorAt(hints, motor.port())))
                .toList();
    }

    private static String port(String name) {
        return " data-port=\"" + name + "\"";
    }

    private static ChassisDrawing twoWheels(DriveFit drive) {
        double width = Math.max(70, drive.trackMillimetres() - 34);
        List<String> elements = new ArrayList<>();
        elements.add(format("<rect %s x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" rx=\"8\"/>", BODY,
                USUAL_FRONT - LENGTH, -width / 2, LENGTH, width));
        elements.addAll(brick());
        elements.add("<circle data-part=\"caster\" id=\"caster\" cx=\"-82\" cy=\"0\" r=\"8\" fill=\"#3c4043\"/>");
        elements.add(wheel("left-wheel", drive.left(), -drive.trackMillimetres() / 2));
        elements.add(wheel("right-wheel", drive.right(), drive.trackMillimetres() / 2));
        return new ChassisDrawing(elements, USUAL_FRONT, width / 2);
    }

    private static List<String> brick() {
        return List.of("<rect x=\"-62\" y=\"-36\" width=\"112\" height=\"72\" rx=\"6\" fill=\"#9aa0a6\"/>",
                "<rect x=\"-10\" y=\"-24\" width=\"46\" height=\"48\" fill=\"#cfd8c7\"/>");
    }

    private static String wheel(String id, DriveFit.Wheel wheel, double y) {
        return format("<rect data-part=\"wheel\" id=\"%s\" x=\"%.2f\" y=\"%.2f\" width=\"%.2f\" height=\"22\" "
                + "rx=\"4\" fill=\"#202124\"%s/>", id, -wheel.diameterMillimetres() / 2, y - 11,
                wheel.diameterMillimetres(), motor(wheel));
    }

    private static String motor(DriveFit.Wheel wheel) {
        return format(" data-port=\"%s\" data-motor=\"%s\" data-diameter-mm=\"%.2f\"",
                wheel.port(), wheel.motor(), wheel.diameterMillimetres())
                + (wheel.gearRatio() == 1 ? "" : format(" data-gear-ratio=\"%.4f\"", wheel.gearRatio()))
                + (wheel.inverted() ? " data-inverted=\"true\"" : "");
    }

    private static ChassisDrawing holonomic(HardwareHints hints) {
        List<String> elements = new ArrayList<>();
        double reach = hints.omniWheels().stream().mapToDouble(wheel -> radius(wheel)).max().orElseThrow();
        elements.add(format("<circle %s r=\"%.1f\"/>", BODY, reach + 15));
        elements.addAll(brick());
        for (HardwareHints.OmniWheel wheel : hints.omniWheels()) {
            elements.add(omniWheel(hints, wheel));
        }
        return new ChassisDrawing(elements, reach + 15, reach / 2);
    }

    /** Distance of an omni wheel from the middle in millimetres. */
    private static double radius(HardwareHints.OmniWheel wheel) {
        double radius = StrictMath.hypot(wheel.x(), wheel.y()) * TyreSize.millimetresPerUnit(wheel.diameter());
        return radius >= LEAST_RADIUS && radius <= GREATEST_RADIUS ? radius : DEFAULT_RADIUS;
    }

    /** The program counts angles counter-clockwise with y to the left, the drawing clockwise with y to the right. */
    private static String omniWheel(HardwareHints hints, HardwareHints.OmniWheel wheel) {
        DriveFit.Wheel motor = new DriveFit.Wheel(wheel.port(), DriveFit.motorAt(hints, wheel.port()),
                TyreSize.millimetres(wheel.diameter()), TyreSize.gearRatio(wheel.gearRatio()),
                hints.reversed().contains(wheel.port()));
        double direction = StrictMath.atan2(-wheel.y(), wheel.x());
        double diameter = motor.diameterMillimetres();
        return format("<rect data-part=\"wheel\" id=\"wheel-%s\" data-omni=\"true\" "
                + "transform=\"translate(%.2f %.2f) rotate(%.2f)\" x=\"%.2f\" y=\"-11\" width=\"%.2f\" "
                + "height=\"22\" rx=\"4\" fill=\"#202124\"%s/>", wheel.port().toLowerCase(Locale.ROOT),
                radius(wheel) * StrictMath.cos(direction), radius(wheel) * StrictMath.sin(direction),
                -wheel.headingDegrees(), -diameter / 2, diameter, motor(motor));
    }

    private static String format(String format, Object... values) {
        return String.format(Locale.ROOT, format, values);
    }
}
