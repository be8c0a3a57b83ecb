package brickless.loading.hints;

/**
 * A wheel as the program describes it, while it is being described; lengths in the program's unit, what is not known is
 * NaN.
 *
 * @param diameter tyre diameter
 * @param offset distance from the middle of the axle
 * @param track distance between both wheels
 * @param gear motor turns per wheel turn, of an omni wheel wheel turns per motor turn, as leJOS has it
 * @param place where an omni wheel is; null for an ordinary wheel
 */
record Axle(double diameter, double offset, double track, double gear, Place place) {
    /** Place of an omni wheel: x ahead, y to the left, driving direction in degrees counter-clockwise from ahead. */
    record Place(double x, double y, double headingDegrees) {}

    private static final Place UNKNOWN = new Place(Double.NaN, Double.NaN, Double.NaN);

    static Axle ordinary(double diameter) {
        return new Axle(diameter, Double.NaN, Double.NaN, 1, null);
    }

    static Axle omni(double diameter) {
        return new Axle(diameter, Double.NaN, Double.NaN, 1, UNKNOWN);
    }

    Axle atOffset(double value) {
        return new Axle(diameter, value, track, gear, place);
    }

    Axle withTrack(double value) {
        return new Axle(diameter, offset, value, gear, place);
    }

    Axle geared(double value) {
        return new Axle(diameter, offset, track, value, place);
    }

    /** At an angle and a distance from the middle, driving across. */
    Axle polar(double angleDegrees, double radius) {
        double angle = StrictMath.toRadians(angleDegrees);
        return cartesian(radius * StrictMath.cos(angle), radius * StrictMath.sin(angle), angleDegrees + 90);
    }

    Axle cartesian(double x, double y, double headingDegrees) {
        return new Axle(diameter, offset, track, gear, new Place(x, y, headingDegrees));
    }

    boolean isOmni() {
        return place != null;
    }

    /** Whether enough is known to build the wheel. */
    boolean isComplete() {
        return !Double.isNaN(diameter) && (place == null || !Double.isNaN(place.x + place.y + place.headingDegrees));
    }
}
