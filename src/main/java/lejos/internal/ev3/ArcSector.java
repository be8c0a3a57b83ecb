package lejos.internal.ev3;

/** The part of a box's ellipse between two angles, in degrees counter-clockwise from 3 o'clock, both ends included. */
final class ArcSector {
    private static final double FULL_DEGREES = 360;
    private static final double TOLERANCE_DEGREES = 1e-9;

    private final int width;
    private final int height;
    private final double fromDegrees;
    private final double lengthDegrees;

    ArcSector(int width, int height, int startDegrees, int arcDegrees) {
        this.width = width;
        this.height = height;
        this.fromDegrees = arcDegrees < 0 ? startDegrees + (double) arcDegrees : startDegrees;
        this.lengthDegrees = Math.abs((double) arcDegrees);
    }

    /** Whether a pixel, given from the box's upper left corner, lies in the sector; the centre always does. */
    boolean contains(int x, int y) {
        double acrossUnits = (2.0 * x - width) * Math.max(1, height);
        double upUnits = (height - 2.0 * y) * Math.max(1, width);
        if (lengthDegrees >= FULL_DEGREES || acrossUnits == 0 && upUnits == 0) {
            return true;
        }
        double degrees = StrictMath.toDegrees(StrictMath.atan2(upUnits, acrossUnits));
        double past = (degrees - fromDegrees) % FULL_DEGREES;
        double beyond = past < -TOLERANCE_DEGREES ? past + FULL_DEGREES : past;
        return beyond <= lengthDegrees + TOLERANCE_DEGREES || beyond >= FULL_DEGREES - TOLERANCE_DEGREES;
    }
}
