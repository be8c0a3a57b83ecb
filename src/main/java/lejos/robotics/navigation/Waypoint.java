package lejos.robotics.navigation;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import lejos.robotics.Transmittable;
import lejos.robotics.geometry.Point;

/** A place on a path, perhaps with a heading to arrive at it with. */
public class Waypoint extends Point implements Transmittable {
    private static final float UNCHECKED = -1;

    /** Heading in degrees. */
    protected float heading;
    /** Whether the heading matters. */
    protected boolean headingRequired;
    /** Greatest distance that {@link #checkValidity} accepts; negative = any. */
    protected float maxPositionError = UNCHECKED;
    /** Greatest difference of heading that {@link #checkValidity} accepts, in degrees; negative = any. */
    protected float maxHeadingError = UNCHECKED;

    /** A place; the heading does not matter. */
    public Waypoint(double x, double y) {
        super((float) x, (float) y);
    }

    /** A place and a heading in degrees. */
    public Waypoint(double x, double y, double heading) {
        this(x, y);
        this.heading = (float) heading;
        this.headingRequired = true;
    }

    /** A place; the heading does not matter. */
    public Waypoint(Point p) {
        this(p.getX(), p.getY());
    }

    /** A place and a heading. */
    public Waypoint(Pose p) {
        this(p.getX(), p.getY(), p.getHeading());
    }

    /** Heading in degrees; 0 if it does not matter. */
    public double getHeading() {
        return heading;
    }

    /** Whether the heading matters. */
    public boolean isHeadingRequired() {
        return headingRequired;
    }

    /** Greatest distance that {@link #checkValidity} accepts; negative = any. */
    public double getMaxPositionError() {
        return maxPositionError;
    }

    /** Sets the greatest distance that {@link #checkValidity} accepts; negative = any. */
    public void setMaxPositionError(double distance) {
        maxPositionError = (float) distance;
    }

    /** Greatest difference of heading that {@link #checkValidity} accepts, in degrees; negative = any. */
    public double getMaxHeadingError() {
        return maxHeadingError;
    }

    /** Sets the greatest difference of heading that {@link #checkValidity} accepts, in degrees; negative = any. */
    public void setMaxHeadingError(double angle) {
        maxHeadingError = (float) angle;
    }

    /** The pose of a robot that has arrived. */
    public Pose getPose() {
        return new Pose(x, y, heading);
    }

    /** Whether a pose is within the errors accepted. Headings are compared as numbers: 179 and −179 differ by 358. */
    public boolean checkValidity(Pose p) {
        boolean near = maxPositionError < 0 || p.distanceTo(this) <= maxPositionError;
        boolean aligned = maxHeadingError < 0 || !headingRequired
                || Math.abs(p.getHeading() - heading) <= maxHeadingError;
        return near && aligned;
    }

    /** Writes x, y and heading as floats, and whether the heading matters. */
    @Override
    public void dumpObject(DataOutputStream dos) throws IOException {
        dos.writeFloat(x);
        dos.writeFloat(y);
        dos.writeFloat(heading);
        dos.writeBoolean(headingRequired);
        dos.flush();
    }

    @Override
    public void loadObject(DataInputStream dis) throws IOException {
        x = dis.readFloat();
        y = dis.readFloat();
        heading = dis.readFloat();
        headingRequired = dis.readBoolean();
    }
}
