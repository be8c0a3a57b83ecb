package lejos.robotics.localization;

import lejos.robotics.SampleProvider;
import lejos.robotics.geometry.Point;
import lejos.robotics.navigation.Move;
import lejos.robotics.navigation.MoveListener;
import lejos.robotics.navigation.MoveProvider;
import lejos.robotics.navigation.Pose;

/**
 * Dead reckoning: adds up the moves of a pilot. Also while a move is in progress {@link #getPose} is up to date.
 *
 * <p>May be used by any thread; this object's lock guards the pose. As a sample provider it gives x, y and heading.
 */
public class OdometryPoseProvider implements PoseProvider, MoveListener, SampleProvider {
    private static final int SAMPLE_SIZE = 3;
    private static final float FULL_TURN = 360;
    private static final float HALF_TURN = 180;

    /** A step that turns by less than this many degrees is taken as straight. */
    private static final float STRAIGHT_DEGREES = 0.2f;

    private MoveProvider provider;
    private float x;
    private float y;
    private float heading;
    private float countedDistance;
    private float countedAngle;
    private boolean current = true;

    /** Begins at the origin and listens to the moves of a pilot. */
    public OdometryPoseProvider(MoveProvider mp) {
        mp.addMoveListener(this);
    }

    @Override
    public synchronized Pose getPose() {
        catchUp();
        return new Pose(x, y, heading);
    }

    @Override
    public synchronized void moveStarted(Move move, MoveProvider mp) {
        provider = mp;
        countedDistance = 0;
        countedAngle = 0;
        current = false;
    }

    /** Tells where the robot is; a move in progress counts from here. */
    @Override
    public synchronized void setPose(Pose aPose) {
        catchUp();
        x = aPose.getX();
        y = aPose.getY();
        heading = aPose.getHeading();
    }

    @Override
    public synchronized void moveStopped(Move move, MoveProvider mp) {
        count(move);
    }

    @Override
    public int sampleSize() {
        return SAMPLE_SIZE;
    }

    @Override
    public void fetchSample(float[] sample, int offset) {
        Pose pose = getPose();
        sample[offset] = pose.getX();
        sample[offset + 1] = pose.getY();
        sample[offset + 2] = pose.getHeading();
    }

    /** Counts what was done so far of a move in progress. */
    private void catchUp() {
        Move move = current ? null : provider.getMovement();
        if (move != null) {
            count(move);
        }
    }

    private void count(Move move) {
        float distance = move.getDistanceTraveled() - countedDistance;
        float angle = move.getAngleTurned() - countedAngle;
        Move.MoveType type = move.getMoveType();
        if (type == Move.MoveType.TRAVEL || Math.abs(angle) < STRAIGHT_DEGREES) {
            step(distance, heading);
        } else if (type == Move.MoveType.ARC) {
            arc(distance, angle);
        }
        heading = normalize(heading + angle);
        countedDistance = move.getDistanceTraveled();
        countedAngle = move.getAngleTurned();
        current = !move.isMoving();
    }

    /** An arc leads where its chord leads, which points half the turn off the old heading. */
    private void arc(float distance, float angle) {
        double half = StrictMath.toRadians(angle) / 2;
        step((float) (distance * StrictMath.sin(half) / half), heading + angle / 2);
    }

    private void step(float distance, float direction) {
        Point end = new Point(x, y).pointAt(distance, direction);
        x = end.x;
        y = end.y;
    }

    private static float normalize(float angle) {
        float wrapped = angle;
        while (wrapped < -HALF_TURN) {
            wrapped += FULL_TURN;
        }
        while (wrapped > HALF_TURN) {
            wrapped -= FULL_TURN;
        }
        return wrapped;
    }
}
