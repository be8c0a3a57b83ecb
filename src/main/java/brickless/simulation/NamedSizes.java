package brickless.simulation;

import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Pattern;

/**
 * Sizes of wheels and axle that a program without a pilot keeps in fields and variables and computes with.
 *
 * @param diameterMillimetres tyre diameter; empty if no name tells
 * @param trackMillimetres distance between the wheels; empty if no name tells
 */
record NamedSizes(OptionalDouble diameterMillimetres, OptionalDouble trackMillimetres) {
    private static final Pattern DIAMETER = Pattern.compile("(?i).*diam.*|.*durchmesser.*");
    private static final Pattern RADIUS = Pattern.compile("(?i).*(wheel|tyre|tire|rad)_?(rad|radius).*"
            + "|.*radius_?(of_?)?(the_?)?wheel.*|(left|right|l|r)?_?radius");
    private static final Pattern CIRCUMFERENCE = Pattern.compile("(?i).*circumference.*|.*wheel_?circ.*|.*umfang.*");
    private static final Pattern TRACK = Pattern.compile("(?i)(.*_)?track(_?(width|length|size|cm|mm|inch(es)?))*"
            + "|.*[a-z]Track|.*axle.*|.*wheel_?base.*|.*wheels?_?(dist|span|gap|separation).*"
            + "|.*between_?(the_?)?wheels.*|.*spurweite.*|.*achs.*");
    private static final Pattern HALF = Pattern.compile("(?i).*(half|halb).*");
    private static final Pattern MILLIMETRES = Pattern.compile(".*(MM|Mm|_mm)|(?i:.*millimet.*)");
    private static final Pattern CENTIMETRES = Pattern.compile(".*(CM|Cm|_cm)|(?i:.*centimet.*)");
    private static final Pattern INCHES = Pattern.compile("(?i).*inch(es)?");

    /** A size and the unit that its name or its value tells. */
    private record Size(double value, double millimetresPerUnit) {
        OptionalDouble millimetres() {
            return OptionalDouble.of(value * millimetresPerUnit);
        }
    }

    /** What the names of numbers tell. */
    static NamedSizes of(Map<String, Double> numbers) {
        Optional<Size> diameter = first(numbers, DIAMETER, 1).or(() -> first(numbers, RADIUS, 2))
                .or(() -> first(numbers, CIRCUMFERENCE, 1 / StrictMath.PI))
                .map(size -> known(size) ? size : new Size(size.value, TyreSize.millimetresPerUnit(size.value)));
        Optional<Size> track = first(numbers, TRACK, 1)
                .map(size -> known(size) ? size
                        : new Size(size.value, diameter.map(Size::millimetresPerUnit).orElse(unitOfTrack(size.value))));
        return new NamedSizes(diameter.map(Size::millimetres).orElse(OptionalDouble.empty()),
                track.map(Size::millimetres).orElse(OptionalDouble.empty()));
    }

    private static boolean known(Size size) {
        return !Double.isNaN(size.millimetresPerUnit);
    }

    /** The first number with such a name; the unit is not a number if the name does not tell it. */
    private static Optional<Size> first(Map<String, Double> numbers, Pattern name, double factor) {
        return numbers.entrySet().stream().filter(number -> name.matcher(number.getKey()).matches()).findFirst()
                .map(number -> new Size(number.getValue() * factor * (HALF.matcher(number.getKey()).matches() ? 2 : 1),
                        unitOf(number.getKey())));
    }

    private static double unitOf(String name) {
        return MILLIMETRES.matcher(name).matches() ? 1 : CENTIMETRES.matcher(name).matches() ? 10
                : INCHES.matcher(name).matches() ? 25.4 : Double.NaN;
    }

    /** Alone, a track is in the first unit in which it fits a robot: centimetres, millimetres, inches, metres. */
    private static double unitOfTrack(double track) {
        for (double unit : TyreSize.MILLIMETRES_PER_UNIT) {
            if (DriveFit.isTrack(track * unit)) {
                return unit;
            }
        }
        return 1;
    }
}
