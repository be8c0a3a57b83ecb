package brickless.simulation;

import brickless.loading.hints.HardwareHints;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.regex.Pattern;

/**
 * Which motors drive a robot, and with what tyres, as far as a program tells.
 *
 * @param leftPort port of the left wheel's motor
 * @param rightPort port of the right wheel's motor
 * @param leftMotor value of {@code data-motor}
 * @param rightMotor value of {@code data-motor}
 * @param diameterMillimetres tyre diameter
 * @param trackMillimetres distance between the wheels
 * @param gearRatio motor turns per wheel turn
 */
record DriveFit(String leftPort, String rightPort, String leftMotor, String rightMotor, double diameterMillimetres, double trackMillimetres,
        double gearRatio) {
    /** Tyres of LEGO kits by outer diameter in millimetres; 56 is the EV3 kit's. */
    private static final double[] TYRES = {24, 30.4, 43.2, 49.6, 56, 62.4, 68.8, 81.6, 94.2};
    private static final double[] MILLIMETRES_PER_UNIT = {10, 1, 25.4, 1000};
    private static final double DEFAULT_DIAMETER = 56;
    private static final double DEFAULT_TRACK = 120;
    private static final double MINIMUM_TRACK = 60;
    private static final double MAXIMUM_TRACK = 400;
    /** Pairs of ports in the order in which people wire two driven wheels, left first. */
    private static final List<String> USUAL_PAIRS = List.of("BC", "AD", "AB", "AC", "CD", "BD");
    private static final Pattern LEFT = Pattern.compile("(?i).*(left|links|gauche|izq).*|[lL]|[lL](m|M)otor|m(otor)?L");
    private static final Pattern RIGHT = Pattern.compile("(?i).*(right|rechts|droit|derech).*|[rR]|[rR](m|M)otor|m(otor)?R");

    static DriveFit of(HardwareHints hints) {
        List<HardwareHints.Wheel> wheels = hints.wheels().stream().limit(2).toList();
        if (wheels.size() == 2) {
            return declared(hints, ordered(wheels));
        }
        List<HardwareHints.Device> pair = guessedPair(hints.motors());
        HardwareHints.Device left = pair.get(0);
        HardwareHints.Device right = pair.get(1);
        if (LEFT.matcher(right.name()).matches() || RIGHT.matcher(left.name()).matches()) {
            left = pair.get(1);
            right = pair.get(0);
        }
        return new DriveFit(left.port(), right.port(), motor(left.lejosClass()), motor(right.lejosClass()), DEFAULT_DIAMETER, DEFAULT_TRACK, 1);
    }

    private static DriveFit declared(HardwareHints hints, List<HardwareHints.Wheel> wheels) {
        HardwareHints.Wheel left = wheels.get(0);
        double unit = millimetresPerUnit(left.diameter());
        double track = left.trackWidth().orElseGet(() -> Math.abs(left.offset().orElse(0)) + Math.abs(wheels.get(1).offset().orElse(0))) * unit;
        boolean plausible = track >= MINIMUM_TRACK && track <= MAXIMUM_TRACK;
        return new DriveFit(left.port(), wheels.get(1).port(), motorAt(hints, left.port()), motorAt(hints, wheels.get(1).port()),
                left.diameter() * unit, plausible ? track : DEFAULT_TRACK, left.gearRatio() > 0 ? left.gearRatio() : 1);
    }

    /** Left wheel first: by name if the names tell, else the one with the smaller offset, as most programs have it. */
    private static List<HardwareHints.Wheel> ordered(List<HardwareHints.Wheel> wheels) {
        HardwareHints.Wheel first = wheels.get(0);
        HardwareHints.Wheel second = wheels.get(1);
        boolean firstIsLeft;
        if (LEFT.matcher(first.name()).matches() || RIGHT.matcher(second.name()).matches()) {
            firstIsLeft = true;
        } else if (LEFT.matcher(second.name()).matches() || RIGHT.matcher(first.name()).matches()) {
            firstIsLeft = false;
        } else {
            firstIsLeft = first.offset().orElse(0) <= second.offset().orElse(0);
        }
        return firstIsLeft ? wheels : List.of(second, first);
    }

    private static List<HardwareHints.Device> guessedPair(List<HardwareHints.Device> motors) {
        List<HardwareHints.Device> candidates = new ArrayList<>(motors.stream().filter(m -> !m.lejosClass().contains("Medium")).toList());
        if (candidates.size() < 2) {
            candidates = new ArrayList<>(motors);
        }
        List<HardwareHints.Device> named = candidates.stream()
                .filter(m -> LEFT.matcher(m.name()).matches() || RIGHT.matcher(m.name()).matches()).toList();
        if (named.size() == 2) {
            return named;
        }
        for (String pair : USUAL_PAIRS) {
            List<HardwareHints.Device> both = candidates.stream().filter(m -> pair.contains(m.port()))
                    .sorted(Comparator.comparing(HardwareHints.Device::port)).toList();
            if (both.size() == 2) {
                return both;
            }
        }
        return List.of(new HardwareHints.Device("B", "EV3LargeRegulatedMotor", ""), new HardwareHints.Device("C", "EV3LargeRegulatedMotor", ""));
    }

    private static String motorAt(HardwareHints hints, String port) {
        return hints.motors().stream().filter(m -> m.port().equals(port)).findFirst().map(m -> motor(m.lejosClass())).orElse("large");
    }

    /** {@code Motor.A} is an {@code NXTRegulatedMotor} in leJOS whatever is plugged in; on an EV3 that is a large motor. */
    private static String motor(String lejosClass) {
        return lejosClass.contains("Medium") ? "medium" : "large";
    }

    /** The unit of length in which a diameter comes closest to a tyre that exists; centimetres win ties. */
    static double millimetresPerUnit(double diameter) {
        double best = MILLIMETRES_PER_UNIT[0];
        double error = Double.POSITIVE_INFINITY;
        for (double unit : MILLIMETRES_PER_UNIT) {
            for (double tyre : TYRES) {
                double ratio = Math.abs(StrictMath.log(diameter * unit / tyre));
                if (ratio < error - 1e-9) {
                    error = ratio;
                    best = unit;
                }
            }
        }
        return best;
    }
}
