package brickless.world;

/** Sample points of a unit disc: rings of 1, 6 and 12 points at the radii that halve their rings' areas. */
final class SpotPattern {
    static final int POINTS = 19;
    private static final double[] COORDINATES = coordinates();

    private SpotPattern() {}

    static double x(int i) {
        return COORDINATES[2 * i];
    }

    static double y(int i) {
        return COORDINATES[2 * i + 1];
    }

    private static double[] coordinates() {
        double[] points = new double[2 * POINTS];
        ring(points, 1, 6, Math.sqrt(4.0 / POINTS));
        ring(points, 7, 12, Math.sqrt(13.0 / POINTS));
        return points;
    }

    private static void ring(double[] points, int first, int count, double radius) {
        for (int i = 0; i < count; i++) {
            double angle = 2 * Math.PI * i / count;
            points[2 * (first + i)] = radius * StrictMath.cos(angle);
            points[2 * (first + i) + 1] = radius * StrictMath.sin(angle);
        }
    }
}
