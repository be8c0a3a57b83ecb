package brickless.simulation;

import brickless.loading.hints.HardwareHints;
import java.util.Comparator;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Predicate;
import java.util.regex.Pattern;

/**
 * Which motors drive a robot with two wheels, and with what tyres, as far as a program tells.
 *
 * @param left left wheel
 * @param right right wheel
 * @param trackMillimetres distance between the wheels
 */
record DriveFit(Wheel left, Wheel right, double trackMillimetres) {
    private static final double DEFAULT_TRACK = 120;
    private static final double MINIMUM_TRACK = 60;
    private static final double MAXIMUM_TRACK = 400;
    /** Pairs of ports in the order in which people wire two driven wheels, left first. */
    private static final List<String> USUAL_PAIRS = List.of("BC", "AD", "AB", "AC", "CD", "BD");
    private static final List<HardwareHints.Device> USUAL_MOTORS =
            List.of(new HardwareHints.Device("B", "EV3LargeRegulatedMotor", ""),
            new HardwareHints.Device("C", "EV3LargeRegulatedMotor", ""));
    /** Names of motors that move something else than the robot. */
    private static final Pattern TOOL =
            Pattern.compile("(?i).*(arm|claw|grip|grab|lift|fork|crane|turret|head|neck|kick|shoot|cannon|sensor"
            + "|sonar|eye|scan|hand|jaw|door|brush|pen|cage|greif|kopf|turm).*");

    /**
     * A driven wheel.
     *
     * @param port port of its motor
     * @param motor value of {@code data-motor}
     * @param diameterMillimetres tyre diameter
     * @param gearRatio motor turns per wheel turn
     * @param inverted whether the motor is mounted the other way round
     */
    record Wheel(String port, String motor, double diameterMillimetres, double gearRatio, boolean inverted) {}

    static DriveFit of(HardwareHints hints) {
        List<HardwareHints.Wheel> wheels = hints.wheels().stream().limit(2).toList();
        if (wheels.size() == 2) {
            return declared(hints, ordered(wheels));
        }
        List<HardwareHints.Device> pair = guessedPair(hints.motors());
        boolean swapped = Side.of(pair.get(1).name()) == Side.LEFT || Side.of(pair.get(0).name()) == Side.RIGHT;
        NamedSizes sizes = NamedSizes.of(hints.numbers());
        double diameter = TyreSize.plausible(sizes.diameterMillimetres().orElse(TyreSize.DEFAULT_MILLIMETRES));
        return new DriveFit(guessed(hints, pair.get(swapped ? 1 : 0), diameter),
                guessed(hints, pair.get(swapped ? 0 : 1), diameter),
                plausible(sizes.trackMillimetres().orElse(DEFAULT_TRACK)));
    }

    private static double plausible(double track) {
        return isTrack(track) ? track : DEFAULT_TRACK;
    }

    /** Whether a robot can have this distance between its wheels in millimetres. */
    static boolean isTrack(double millimetres) {
        return millimetres >= MINIMUM_TRACK && millimetres <= MAXIMUM_TRACK;
    }

    private static Wheel guessed(HardwareHints hints, HardwareHints.Device motor, double diameter) {
        return new Wheel(motor.port(), motorOf(motor), diameter, 1, hints.reversed().contains(motor.port()));
    }

    private static DriveFit declared(HardwareHints hints, List<HardwareHints.Wheel> wheels) {
        HardwareHints.Wheel left = wheels.get(0);
        HardwareHints.Wheel right = wheels.get(1);
        double track = left.trackWidth().orElse(distance(left.offset(), right.offset()));
        double unit = TyreSize.millimetresPerUnit(left.diameter(), track);
        return new DriveFit(declared(hints, left, unit), declared(hints, right, unit), plausible(track * unit));
    }

    private static double distance(OptionalDouble left, OptionalDouble right) {
        double one = Math.abs(left.orElse(right.orElse(0)));
        return one + Math.abs(right.orElse(one));
    }

    private static Wheel declared(HardwareHints hints, HardwareHints.Wheel wheel, double unit) {
        return new Wheel(wheel.port(), motorAt(hints, wheel.port()), TyreSize.plausible(wheel.diameter() * unit),
                TyreSize.gearRatio(wheel.gearRatio()), hints.reversed().contains(wheel.port()));
    }

    /** Left wheel first: by name if the names tell, else the one with the smaller offset, as most programs have it. */
    private static List<HardwareHints.Wheel> ordered(List<HardwareHints.Wheel> wheels) {
        HardwareHints.Wheel first = wheels.get(0);
        HardwareHints.Wheel second = wheels.get(1);
        boolean firstIsLeft;
        if (Side.of(first.name()) == Side.LEFT || Side.of(second.name()) == Side.RIGHT) {
            firstIsLeft = true;
        } else if (Side.of(second.name()) == Side.LEFT || Side.of(first.name()) == Side.RIGHT) {
            firstIsLeft = false;
        } else {
            firstIsLeft = first.offset().orElse(0) <= second.offset().orElse(0);
        }
        return firstIsLeft ? wheels : List.of(second, first);
    }

    /**
     * Two motors that are named after sides, else a usual pair of ports; large motors before medium ones, tools last.
     */
    private static List<HardwareHints.Device> guessedPair(List<HardwareHints.Device> motors) {
        List<HardwareHints.Device> wheels = twoOrMore(motors, motor -> !TOOL.matcher(motor.name()).matches());
        List<HardwareHints.Device> large = twoOrMore(wheels, motor -> !motorOf(motor).equals("medium"));
        List<HardwareHints.Device> candidates = large.size() < wheels.size()
                ? large : twoOrMore(wheels, motor -> motorOf(motor).equals("medium"));
        List<HardwareHints.Device> named = candidates.stream().filter(motor -> sideOf(motor) != Side.UNKNOWN).toList();
        if (named.size() == 2 && sideOf(named.get(0)) != sideOf(named.get(1))) {
            return named;
        }
        return USUAL_PAIRS.stream().map(pair -> at(pair, candidates)).filter(both -> both.size() == 2).findFirst()
                .orElse(USUAL_MOTORS);
    }

    private static Side sideOf(HardwareHints.Device motor) {
        return Side.of(motor.name());
    }

    /** The motors of a kind if they are two or more, else all. */
    private static List<HardwareHints.Device> twoOrMore(List<HardwareHints.Device> motors,
            Predicate<HardwareHints.Device> kind) {
        List<HardwareHints.Device> some = motors.stream().filter(kind).toList();
        return some.size() >= 2 ? some : motors;
    }

    private static List<HardwareHints.Device> at(String ports, List<HardwareHints.Device> motors) {
        return motors.stream().filter(motor -> ports.contains(motor.port()))
                .sorted(Comparator.comparing(HardwareHints.Device::port)).toList();
    }

    /** Value of {@code data-motor} for the motor that a program uses at a port. */
    static String motorAt(HardwareHints hints, String port) {
        return hints.motors().stream().filter(motor -> motor.port().equals(port)).findFirst().map(DriveFit::motorOf)
                .orElse("large");
    }

    /**
     * {@code Motor.A} is an {@code NXTRegulatedMotor} in leJOS whatever is plugged in; on an EV3 that is a large motor.
     */
    private static String motorOf(HardwareHints.Device motor) {
        return motor.lejosClass().contains("Medium") ? "medium" : "large";
    }
}
