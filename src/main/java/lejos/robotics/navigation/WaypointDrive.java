package lejos.robotics.navigation;

import java.util.function.BooleanSupplier;
import lejos.robotics.localization.PoseProvider;
import lejos.utility.Delay;

/**
 * Drives to a waypoint: turns and drives straight ahead or, with a pilot that cannot turn on the spot, along arcs.
 *
 * @param pilot drives
 * @param minRadius least radius of the pilot's arcs; 0 if it turns on the spot
 */
record WaypointDrive(MoveController pilot, float minRadius) {
    private static final int POLL_MILLIS = 1;
    private static final float FULL_TURN = 360;
    private static final float HALF_TURN = 180;

    /** How a drive ended. */
    enum Result { ARRIVED, INTERRUPTED, NO_WAY }

    static WaypointDrive of(MoveController pilot) {
        return new WaypointDrive(pilot, pilot instanceof ArcMoveController arcs ? (float) arcs.getMinRadius() : 0);
    }

    /**
     * Drives to a waypoint.
     *
     * @param going false from when the drive is to be given up
     */
    Result driveTo(Waypoint destination, PoseProvider poses, BooleanSupplier going) {
        return minRadius == 0 ? turnAndTravel(destination, poses, going) : followArcs(destination, poses, going);
    }

    private Result turnAndTravel(Waypoint destination, PoseProvider poses, BooleanSupplier going) {
        RotateMoveController turner = (RotateMoveController) pilot;
        float bearing = poses.getPose().relativeBearing(destination);
        if (!move(() -> turner.rotate(bearing, true), going)) {
            return Result.INTERRUPTED;
        }
        float distance = poses.getPose().distanceTo(destination);
        if (!move(() -> pilot.travel(distance, true), going)) {
            return Result.INTERRUPTED;
        }
        if (destination.isHeadingRequired()) {
            double turn = shortestTurn((float) destination.getHeading() - poses.getPose().getHeading());
            turner.rotate(turn, false);
        }
        return going.getAsBoolean() ? Result.ARRIVED : Result.INTERRUPTED;
    }

    /**
     * Begins a move and waits for its end; false if the drive is given up. Who interrupts it stops the pilot, but
     * perhaps just before the move begins: then the move is stopped here.
     */
    private boolean move(Runnable motion, BooleanSupplier going) {
        if (!going.getAsBoolean()) {
            return false;
        }
        motion.run();
        if (!going.getAsBoolean()) {
            pilot.stop();
        }
        while (going.getAsBoolean() && pilot.isMoving()) {
            Delay.msDelay(POLL_MILLIS);
        }
        return going.getAsBoolean();
    }

    private Result followArcs(Waypoint destination, PoseProvider poses, BooleanSupplier going) {
        ArcMoveController arcs = (ArcMoveController) pilot;
        Pose start = poses.getPose();
        Move[] way = destination.isHeadingRequired()
                ? ArcAlgorithms.getBestPath(start, minRadius, destination.getPose(), minRadius)
                : ArcAlgorithms.getBestPath(start, destination, minRadius);
        if (way == null) {
            return Result.NO_WAY;
        }
        for (Move move : way) {
            if (!going.getAsBoolean()) {
                return Result.INTERRUPTED;
            }
            arcs.travelArc(move.getArcRadius(), move.getDistanceTraveled(), false);
        }
        return going.getAsBoolean() ? Result.ARRIVED : Result.INTERRUPTED;
    }

    /** The same change of heading with at most half a turn. */
    static float shortestTurn(float angle) {
        float turn = angle % FULL_TURN;
        if (turn > HALF_TURN) {
            return turn - FULL_TURN;
        }
        return turn < -HALF_TURN ? turn + FULL_TURN : turn;
    }
}
