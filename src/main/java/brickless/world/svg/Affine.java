package brickless.world.svg;

import brickless.units.Angles;
import brickless.world.Point2;

/**
 * The map x' = a·x + c·y + e, y' = b·x + d·y + f, as SVG's {@code matrix(a b c d e f)}; the same bits on every machine.
 */
record Affine(double a, double b, double c, double d, double e, double f) {
    static final Affine IDENTITY = new Affine(1, 0, 0, 1, 0, 0);

    static Affine translate(double x, double y) {
        return new Affine(1, 0, 0, 1, x, y);
    }

    static Affine scale(double x, double y) {
        return new Affine(x, 0, 0, y, 0, 0);
    }

    /** Clockwise on the page. Quarter turns are exact. */
    static Affine rotate(double degrees) {
        double turn = Angles.normalizedDegrees(degrees);
        if (turn % 90 == 0) {
            int quarter = (int) (turn / 90);
            double cos = quarter == 0 ? 1 : Math.abs(quarter) == 2 ? -1 : 0;
            double sin = Math.abs(quarter) == 1 ? quarter : 0;
            return new Affine(cos, sin, -sin, cos, 0, 0);
        }
        double radians = Angles.radiansFromDegrees(turn);
        double cos = StrictMath.cos(radians);
        double sin = StrictMath.sin(radians);
        return new Affine(cos, sin, -sin, cos, 0, 0);
    }

    static Affine skewX(double degrees) {
        return new Affine(1, 0, StrictMath.tan(Angles.radiansFromDegrees(degrees)), 1, 0, 0);
    }

    static Affine skewY(double degrees) {
        return new Affine(1, StrictMath.tan(Angles.radiansFromDegrees(degrees)), 0, 1, 0, 0);
    }

    /** First {@code inner}, then this one: the meaning of nesting. */
    Affine then(Affine inner) {
        return new Affine(a * inner.a + c * inner.b, b * inner.a + d * inner.b, a * inner.c + c * inner.d, b * inner.c
                + d * inner.d, a * inner.e + c * inner.f + e, b * inner.e + d * inner.f + f);
    }

    Point2 apply(Point2 p) {
        return new Point2(a * p.x() + c * p.y() + e, b * p.x() + d * p.y() + f);
    }

    double determinant() {
        return a * d - b * c;
    }

    boolean isFinite() {
        return Double.isFinite(a + b + c + d + e + f) && Double.isFinite(determinant());
    }

    /** Whether it is so flat that areas vanish. */
    boolean isSingular() {
        return Math.abs(determinant()) < 1e-12;
    }

    /** Inverse of a map that is not singular. */
    Affine inverse() {
        double det = determinant();
        return new Affine(d / det, -b / det, -c / det, a / det, (c * f - d * e) / det, (b * e - a * f) / det);
    }

    /** Greatest factor by which a length grows. */
    double greatestScale() {
        double half = (a * a + b * b + c * c + d * d) / 2;
        double det = determinant();
        return Math.sqrt(half + Math.sqrt(Math.max(0, half * half - det * det)));
    }

    /** Direction of the local +x axis, radians clockwise from +x. */
    double headingRadians() {
        return StrictMath.atan2(b, a);
    }
}
