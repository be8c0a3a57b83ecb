package lejos.robotics.navigation;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import lejos.robotics.Transmittable;

/**
 * A piece of a robot's way: a distance, a change of heading in degrees, and how they go together.
 *
 * <p>Of an arc, the distance is along it (negative backward), and the radius is positive if the centre is to the left.
 */
public class Move implements Transmittable {
    private static final float FULL_TURN = 360;

    /** Below this many degrees the radius of an arc is not worth computing. */
    private static final float STRAIGHT_DEGREES = 0.5f;

    private MoveType moveType;
    private float distance;
    private float angle;
    private float arcRadius = Float.POSITIVE_INFINITY;
    private float travelSpeed;
    private float rotateSpeed;
    private boolean moving;
    private long timeStamp = System.currentTimeMillis();

    /** Kinds of moves. */
    public enum MoveType {
        /** Straight ahead or back. */
        TRAVEL,
        /** On the spot. */
        ROTATE,
        /** Along a circle. */
        ARC,
        /** None. */
        STOP
    }

    /** A move whose kind follows from which of distance and angle are zero. */
    public Move(float distance, float angle, boolean isMoving) {
        this(typeOf(distance, angle), distance, angle, isMoving);
    }

    /** A move with its speeds in units and in degrees per second. */
    public Move(MoveType type, float distance, float angle, float travelSpeed, float rotateSpeed, boolean isMoving) {
        this(type, distance, angle, isMoving);
        setDynamics(travelSpeed, rotateSpeed);
    }

    /** A move. */
    public Move(MoveType type, float distance, float angle, boolean isMoving) {
        setValues(type, distance, angle, isMoving);
    }

    /** A move along an arc of an angle and a radius. */
    public Move(boolean isMoving, float angle, float radius) {
        this(convertAngleToDistance(angle, radius), angle, isMoving);
        arcRadius = radius;
    }

    /** Makes this another move, now. Without a turn worth mentioning the radius stays as it was. */
    public void setValues(MoveType type, float distance, float angle, boolean isMoving) {
        this.moveType = type;
        this.distance = distance;
        this.angle = angle;
        this.moving = isMoving;
        this.timeStamp = System.currentTimeMillis();
        if (Math.abs(angle) > STRAIGHT_DEGREES) {
            arcRadius = (float) (distance / StrictMath.toRadians(angle));
        }
    }

    /** Sets the speeds in units and in degrees per second. */
    public void setDynamics(float travelSpeed, float rotateSpeed) {
        this.travelSpeed = travelSpeed;
        this.rotateSpeed = rotateSpeed;
    }

    /** Distance, negative backward. */
    public float getDistanceTraveled() {
        return distance;
    }

    /** When the move was noted, in milliseconds. */
    public long getTimeStamp() {
        return timeStamp;
    }

    /** Change of heading in degrees, to the left positive. */
    public float getAngleTurned() {
        return angle;
    }

    /** Kind of move. */
    public MoveType getMoveType() {
        return moveType;
    }

    /** Radius, positive if the centre is to the left; infinite for a straight line. */
    public float getArcRadius() {
        return arcRadius;
    }

    /** Speed in units per second. */
    public float getTravelSpeed() {
        return travelSpeed;
    }

    /** Speed in degrees per second. */
    public float getRotateSpeed() {
        return rotateSpeed;
    }

    /** Whether the robot was moving when the move was noted. */
    public boolean isMoving() {
        return moving;
    }

    /** Angle in degrees of an arc of a distance on a circle of a radius. */
    public static float convertDistanceToAngle(float distance, float turnRadius) {
        return (float) (distance * FULL_TURN / (2 * Math.PI * turnRadius));
    }

    /** Distance along an arc of an angle in degrees on a circle of a radius. */
    public static float convertAngleToDistance(float angle, float turnRadius) {
        return (float) (angle * 2 * Math.PI * turnRadius / FULL_TURN);
    }

    /** Writes the kind as a byte, then travel speed, rotate speed, distance, angle and radius as floats. */
    @Override
    public void dumpObject(DataOutputStream dos) throws IOException {
        dos.writeByte(moveType.ordinal());
        dos.writeFloat(travelSpeed);
        dos.writeFloat(rotateSpeed);
        dos.writeFloat(distance);
        dos.writeFloat(angle);
        dos.writeFloat(arcRadius);
        dos.flush();
    }

    @Override
    public void loadObject(DataInputStream dis) throws IOException {
        moveType = MoveType.values()[dis.readByte()];
        travelSpeed = dis.readFloat();
        rotateSpeed = dis.readFloat();
        distance = dis.readFloat();
        angle = dis.readFloat();
        arcRadius = dis.readFloat();
    }

    @Override
    public String toString() {
        return switch (moveType) {
            case TRAVEL -> "TRAVEL " + distance + " at " + travelSpeed;
            case ROTATE -> "ROTATE " + angle + " at " + rotateSpeed;
            case ARC -> "ARC  of " + arcRadius + " for " + angle + "degrees  at " + travelSpeed;
            case STOP -> "STOP ";
        };
    }

    private static MoveType typeOf(float distance, float angle) {
        if (distance == 0) {
            return angle == 0 ? MoveType.STOP : MoveType.ROTATE;
        }
        return angle == 0 ? MoveType.TRAVEL : MoveType.ARC;
    }
}
