package lejos.robotics.geometry;

/** A point in single precision, which is also the vector from the origin to it. */
public class Point extends Point2D.Float {
    /** A point. */
    public Point(float x, float y) {
        super(x, y);
    }

    /** The point at distance 1 from the origin in a direction in radians, turned <i>clockwise</i> from +x (y up). */
    public Point(float radians) {
        super((float) StrictMath.cos(radians), (float) -StrictMath.sin(radians));
    }

    /** Direction from here to a point, in degrees counter-clockwise from +x, −180 to 180. */
    public float angleTo(Point p) {
        return (float) StrictMath.toDegrees(StrictMath.atan2(p.y - y, p.x - x));
    }

    /** Moves the point by a vector. */
    public void translate(float dx, float dy) {
        x += dx;
        y += dy;
    }

    /** Moves the other point here. */
    public Point copyTo(Point p) {
        p.moveTo(this);
        return p;
    }

    @Override
    public Point clone() {
        return new Point(x, y);
    }

    /** The sum of two vectors. */
    public Point add(Point other) {
        return clone().addWith(other);
    }

    /** Adds a vector to this one and returns this one. */
    public Point addWith(Point other) {
        x += other.x;
        y += other.y;
        return this;
    }

    /** Moves this point to where another is. */
    public void moveTo(Point p) {
        x = p.x;
        y = p.y;
    }

    /** The difference of two vectors. */
    public Point subtract(Point other) {
        return clone().subtractWith(other);
    }

    /** The vector of the same direction, shorter by a length. */
    public Point subtract(float length) {
        float scale = (length() - length) / length();
        return multiply(scale);
    }

    /** This vector times a number. */
    public Point multiply(float scale) {
        return clone().multiplyBy(scale);
    }

    /** The vector of length 1 and the same direction; not a number if this one has no length. */
    public Point getNormalized() {
        return clone().normalize();
    }

    /** The opposite vector. */
    public Point reverse() {
        return new Point(-x, -y);
    }

    /** The point of the straight line, continued beyond its ends, that is nearest to this one. */
    public Point projectOn(Line line) {
        Point start = line.getP1();
        Point along = line.getP2().subtractWith(start);
        float part = subtract(start).dotProduct(along) / along.dotProduct(along);
        return start.addWith(along.multiplyBy(part));
    }

    /** Direction of this vector in radians counter-clockwise from +x, −π to π. */
    public float angle() {
        return (float) StrictMath.atan2(y, x);
    }

    /** This vector turned a quarter to the left. */
    public Point leftOrth() {
        return new Point(-y, x);
    }

    /** This vector turned a quarter to the right. */
    public Point rightOrth() {
        return new Point(y, -x);
    }

    /** Subtracts a vector from this one and returns this one. */
    public Point subtractWith(Point other) {
        x -= other.x;
        y -= other.y;
        return this;
    }

    /** Multiplies this vector by a number and returns it. */
    public Point multiplyBy(float scale) {
        x *= scale;
        y *= scale;
        return this;
    }

    /** Length of this vector. */
    public float length() {
        return (float) Math.sqrt(dotProduct(this));
    }

    /** Makes this vector's length 1 and returns it; not a number if it has no length. */
    public Point normalize() {
        float length = length();
        x /= length;
        y /= length;
        return this;
    }

    /** Turns this vector a quarter to the left and returns it. */
    public Point makeLeftOrth() {
        moveTo(leftOrth());
        return this;
    }

    /** Turns this vector a quarter to the right and returns it. */
    public Point makeRightOrth() {
        moveTo(rightOrth());
        return this;
    }

    /** Scalar product of two vectors. */
    public float dotProduct(Point other) {
        return x * other.x + y * other.y;
    }

    /** The point at a distance from here in a direction in degrees counter-clockwise from +x. */
    public Point pointAt(float distance, float angle) {
        double radians = StrictMath.toRadians(angle);
        double dx = distance * StrictMath.cos(radians);
        double dy = distance * StrictMath.sin(radians);
        return new Point((float) (x + dx), (float) (y + dy));
    }
}
