package lejos.robotics.navigation;

import java.util.ArrayList;
import java.util.List;

/** Notes what it is told, in order. */
final class Journal implements MoveListener, NavigationListener {
    private final List<String> lines = new ArrayList<>();
    private final List<Move> moves = new ArrayList<>();
    private Runnable atStart = () -> {};
    private Runnable atStop = () -> {};

    /** Something to do once, when told of a start. */
    void onStart(Runnable action) {
        atStart = action;
    }

    /** Something to do once, when told of a stop. */
    void onStop(Runnable action) {
        atStop = action;
    }

    synchronized List<String> lines() {
        return new ArrayList<>(lines);
    }

    synchronized List<Move> moves() {
        return new ArrayList<>(moves);
    }

    private synchronized void note(String line) {
        lines.add(line);
    }

    private synchronized void note(String what, Move move) {
        moves.add(move);
        lines.add(what + " " + move.getMoveType() + " " + number(move.getDistanceTraveled()) + " "
                + number(move.getAngleTurned()));
    }

    private static String number(float value) {
        return Float.isInfinite(value) ? String.valueOf(value) : String.valueOf(Math.round(value));
    }

    @Override
    public void moveStarted(Move event, MoveProvider mp) {
        note("started", event);
        Runnable action = atStart;
        atStart = () -> {};
        action.run();
    }

    @Override
    public void moveStopped(Move event, MoveProvider mp) {
        note("stopped", event);
        Runnable action = atStop;
        atStop = () -> {};
        action.run();
    }

    @Override
    public void atWaypoint(Waypoint waypoint, Pose pose, int sequence) {
        note("at " + waypoint.x + " " + waypoint.y + ", " + sequence);
        Runnable action = atStop;
        atStop = () -> {};
        action.run();
    }

    @Override
    public void pathComplete(Waypoint waypoint, Pose pose, int sequence) {
        note("complete " + sequence);
    }

    @Override
    public void pathInterrupted(Waypoint waypoint, Pose pose, int sequence) {
        note("interrupted " + (waypoint == null ? "nowhere" : waypoint.x + " " + waypoint.y) + ", " + sequence);
    }
}
