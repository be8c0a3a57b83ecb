package lejos.robotics.navigation;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.Locale;
import lejos.robotics.Transmittable;
import lejos.robotics.geometry.Point;

/** Where a robot is and where it looks: a location and a heading in degrees counter-clockwise from +x. */
public class Pose implements Transmittable {
    private static final float FULL_TURN = 360;
    private static final float HALF_TURN = 180;

    /** An arc that turns by less than this many degrees is driven as a straight line. */
    private static final float STRAIGHT_DEGREES = 0.5f;

    /** A straight line shorter than this counts as none. */
    private static final float LEAST_DISTANCE = 0.01f;

    /** How {@link #toString} writes x, y and heading. */
    protected static String format = "X:%.0f Y:%.0f H:%.0f";

    /** Where. */
    protected Point _location;

    /** Heading in degrees. */
    protected float _heading;

    /** At the origin, looking along x. */
    public Pose() {
        this(0, 0, 0);
    }

    /** A pose; the heading in degrees is taken as it is. */
    public Pose(float x, float y, float heading) {
        _location = new Point(x, y);
        _heading = heading;
    }

    /** Turns by an angle in degrees; the heading is then from −180 (not included) to 180. */
    public void rotateUpdate(float angle) {
        _heading = normalize(_heading + angle);
    }

    /** Moves straight ahead by a distance. */
    public void moveUpdate(float distance) {
        double heading = StrictMath.toRadians(_heading);
        translate((float) (distance * StrictMath.cos(heading)), (float) (distance * StrictMath.sin(heading)));
    }

    /** Moves by a vector and keeps the heading. */
    public void translate(float dx, float dy) {
        _location.translate(dx, dy);
    }

    /**
     * Moves along an arc of a circle.
     *
     * @param distance length of the arc, negative backward
     * @param turnAngle change of heading in degrees
     */
    public void arcUpdate(float distance, float turnAngle) {
        if (Math.abs(turnAngle) > STRAIGHT_DEGREES) {
            double turn = StrictMath.toRadians(turnAngle);
            double heading = StrictMath.toRadians(_heading);
            double radius = distance / turn;
            double dx = radius * (StrictMath.sin(heading + turn) - StrictMath.sin(heading));
            double dy = radius * (StrictMath.cos(heading) - StrictMath.cos(heading + turn));
            translate((float) dx, (float) dy);
        } else if (Math.abs(distance) > LEAST_DISTANCE) {
            moveUpdate(distance);
        }
        rotateUpdate(turnAngle);
    }

    /** Direction of a point from here, in degrees from +x, −180 to 180. */
    public float angleTo(Point destination) {
        return _location.angleTo(destination);
    }

    /** Angle to turn by to look at a point, in degrees. */
    public float relativeBearing(Point destination) {
        float bearing = angleTo(destination) - _heading;
        if (bearing < -HALF_TURN) {
            return bearing + FULL_TURN;
        }
        return bearing > HALF_TURN ? bearing - FULL_TURN : bearing;
    }

    /** Distance to a point. */
    public float distanceTo(Point destination) {
        return (float) _location.distance(destination);
    }

    /** The point at a distance in a direction in degrees from +x, whatever the heading. */
    public Point pointAt(float distance, float bearing) {
        return _location.pointAt(distance, bearing);
    }

    /** Heading in degrees. */
    public float getHeading() {
        return _heading;
    }

    /** The x coordinate. */
    public float getX() {
        return _location.x;
    }

    /** The y coordinate. */
    public float getY() {
        return _location.y;
    }

    /** Where: the pose's own point, which moves with it. */
    public Point getLocation() {
        return _location;
    }

    /** Makes a point the pose's own. */
    public void setLocation(Point p) {
        _location = p;
    }

    /** Moves here. */
    public void setLocation(float x, float y) {
        _location = new Point(x, y);
    }

    /** Sets the heading in degrees, taken as it is. */
    public void setHeading(float heading) {
        _heading = heading;
    }

    @Override
    public String toString() {
        return String.format(Locale.ROOT, format, _location.x, _location.y, _heading);
    }

    /** Writes x, y and heading as floats. */
    @Override
    public void dumpObject(DataOutputStream dos) throws IOException {
        dos.writeFloat(_location.x);
        dos.writeFloat(_location.y);
        dos.writeFloat(_heading);
        dos.flush();
    }

    @Override
    public void loadObject(DataInputStream dis) throws IOException {
        float x = dis.readFloat();
        setLocation(x, dis.readFloat());
        _heading = dis.readFloat();
    }

    private static float normalize(float angle) {
        float heading = angle;
        while (heading > HALF_TURN) {
            heading -= FULL_TURN;
        }
        while (heading <= -HALF_TURN) {
            heading += FULL_TURN;
        }
        return heading;
    }
}
