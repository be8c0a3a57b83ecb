package brickless.simulation;

import java.util.Map;
import java.util.OptionalDouble;
import java.util.regex.Pattern;

/**
 * Sizes of wheels and axle that a program without a pilot keeps in fields and variables and computes with.
 *
 * @param diameterMillimetres tyre diameter; empty if no name tells
 * @param trackMillimetres distance between the wheels; empty if no name tells
 */
record NamedSizes(OptionalDouble diameterMillimetres, OptionalDouble trackMillimetres) {
    private static final Pattern DIAMETER = Pattern.compile("(?i).*diam.*|.*durchmesser.*|.*diametre.*");
    private static final Pattern RADIUS = Pattern.compile("(?i).*(wheel|tyre|tire|rad)_?(rad|radius).*|.*radius_?(of_?)?(the_?)?wheel.*"
            + "|(left|right|l|r)?_?radius");
    private static final Pattern CIRCUMFERENCE = Pattern.compile("(?i).*circumference.*|.*wheel_?circ.*|.*umfang.*");
    private static final Pattern TRACK = Pattern.compile("(?i)(.*_)?track(_?(width|length|size|cm|mm))*|.*[a-z]Track|.*axle.*|.*wheel_?base.*"
            + "|.*wheels?_?(dist|span|gap|separation).*|.*between_?(the_?)?wheels.*|.*spurweite.*|.*achs.*");

    /** What the names of numbers tell. */
    static NamedSizes of(Map<String, Double> numbers) {
        OptionalDouble diameter = first(numbers, DIAMETER, 1);
        diameter = diameter.isPresent() ? diameter : first(numbers, RADIUS, 2);
        diameter = diameter.isPresent() ? diameter : first(numbers, CIRCUMFERENCE, 1 / StrictMath.PI);
        OptionalDouble track = first(numbers, TRACK, 1);
        if (diameter.isEmpty()) {
            return new NamedSizes(diameter, track.isEmpty() ? track : OptionalDouble.of(trackMillimetres(track.getAsDouble())));
        }
        double unit = TyreSize.millimetresPerUnit(diameter.getAsDouble());
        return new NamedSizes(OptionalDouble.of(TyreSize.millimetres(diameter.getAsDouble())),
                track.isEmpty() ? track : OptionalDouble.of(track.getAsDouble() * unit));
    }

    private static OptionalDouble first(Map<String, Double> numbers, Pattern name, double factor) {
        return numbers.entrySet().stream().filter(number -> name.matcher(number.getKey()).matches()).mapToDouble(number -> number.getValue() * factor)
                .findFirst();
    }

    /** Alone, a track is in the first unit in which it fits a robot: centimetres, millimetres, inches, metres. */
    private static double trackMillimetres(double track) {
        for (double unit : TyreSize.MILLIMETRES_PER_UNIT) {
            if (DriveFit.isTrack(track * unit)) {
                return track * unit;
            }
        }
        return track;
    }
}
