package lejos.robotics.navigation;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import lejos.robotics.localization.OdometryPoseProvider;
import lejos.robotics.localization.PoseProvider;
import lejos.robotics.pathfinding.Path;

/**
 * Drives a robot along a path of waypoints, on a daemon thread of its own. To each waypoint it turns and drives
 * straight ahead, once; a pilot whose least radius is not 0 is led along arcs.
 *
 * <p>Listeners hear of waypoints on the navigator's thread, while {@link #isMoving} is still true, and of interruptions
 * on the thread that interrupts. May be used by several threads; this object's lock guards the path and how far it is
 * done, and is not held while pilot or listeners are called.
 */
public class Navigator implements WaypointListener {
    private final MoveController pilot;
    private final WaypointDrive drive;
    private final List<NavigationListener> listeners = new CopyOnWriteArrayList<>();
    private volatile PoseProvider poseProvider;

    // Guarded by this.
    private Path path = new Path();
    private Waypoint destination;
    private boolean going;
    private int run;
    private boolean singleStep;
    private int sequence;
    private Thread driver;

    /** A navigator that reckons the pose from the pilot's moves. */
    public Navigator(MoveController pilot) {
        this(pilot, null);
    }

    /**
     * A navigator.
     *
     * @param pilot drives; its least radius now says whether it is led along arcs
     * @param poseProvider knows the pose; null to reckon it from the pilot's moves
     */
    public Navigator(MoveController pilot, PoseProvider poseProvider) {
        this.pilot = pilot;
        this.drive = WaypointDrive.of(pilot);
        this.poseProvider = poseProvider == null ? new OdometryPoseProvider(pilot) : poseProvider;
    }

    /** Replaces what knows the pose. */
    public void setPoseProvider(PoseProvider aProvider) {
        poseProvider = aProvider;
    }

    /** Adds a listener; listeners are called in the order added. */
    public void addNavigationListener(NavigationListener listener) {
        listeners.add(listener);
    }

    /** What knows the pose. */
    public PoseProvider getPoseProvider() {
        return poseProvider;
    }

    /** The pilot. */
    public MoveController getMoveController() {
        return pilot;
    }

    /** Replaces the path, stopping if it is being followed; the new one is not followed yet, and not copied. */
    public void setPath(Path aPath) {
        stopIfMoving();
        synchronized (this) {
            path = aPath;
            singleStep = false;
            sequence = 0;
        }
    }

    /** Removes all waypoints, stopping if the path is being followed. */
    public void clearPath() {
        stopIfMoving();
        synchronized (this) {
            path.clear();
        }
    }

    private void stopIfMoving() {
        if (isMoving()) {
            stop();
        }
    }

    /** The waypoints yet to be reached: the navigator's own list. */
    public synchronized Path getPath() {
        return path;
    }

    /** Begins to follow a path, from which each waypoint is removed when it is reached; returns at once. */
    public void followPath(Path aPath) {
        synchronized (this) {
            path = aPath;
        }
        followPath();
    }

    /** Begins or continues to follow the path, if it is not empty; returns at once. */
    public synchronized void followPath() {
        if (path.isEmpty() || going) {
            return;
        }
        going = true;
        run++;
        if (driver == null) {
            driver = new Thread(this::driveOn, "navigator");
            driver.setDaemon(true);
            driver.start();
        }
        notifyAll();
    }

    /** Says whether to stop at each waypoint of the present path. */
    public synchronized void singleStep(boolean yes) {
        singleStep = yes;
    }

    /** Adds a waypoint to the path and begins to follow it; returns at once. */
    public void goTo(Waypoint destination) {
        addWaypoint(destination);
        followPath();
    }

    /** Adds a waypoint to the path and begins to follow it; returns at once. */
    public void goTo(float x, float y) {
        goTo(new Waypoint(x, y));
    }

    /** Adds a waypoint with a heading in degrees to the path and begins to follow it; returns at once. */
    public void goTo(float x, float y, float heading) {
        goTo(new Waypoint(x, y, heading));
    }

    /**
     * Turns to a heading in degrees, if the pilot can, and returns when done.
     *
     * @return false if the robot follows a path, and so does not turn
     */
    public boolean rotateTo(double angle) {
        if (isMoving()) {
            return false;
        }
        if (pilot instanceof RotateMoveController turner) {
            turner.rotate(WaypointDrive.shortestTurn((float) angle - poseProvider.getPose().getHeading()), false);
        }
        return true;
    }

    /** Adds a waypoint to the path. In an empty path it is the first: counting begins anew. */
    @Override
    public synchronized void addWaypoint(Waypoint aWaypoint) {
        if (path.isEmpty()) {
            sequence = 0;
            singleStep = false;
        }
        path.add(aWaypoint);
    }

    /** Adds a waypoint to the path. */
    public void addWaypoint(float x, float y) {
        addWaypoint(new Waypoint(x, y));
    }

    /** Adds a waypoint with a heading in degrees to the path. */
    public void addWaypoint(float x, float y, float heading) {
        addWaypoint(new Waypoint(x, y, heading));
    }

    /** Stops and tells the listeners, even if the robot was resting. {@link #followPath()} goes on. */
    public void stop() {
        Waypoint aim;
        int count;
        synchronized (this) {
            going = false;
            aim = destination;
            count = sequence;
            notifyAll();
        }
        pilot.stop();
        tellInterrupted(aim, count);
    }

    private void tellInterrupted(Waypoint aim, int count) {
        Pose pose = poseProvider.getPose();
        for (NavigationListener listener : listeners) {
            listener.pathInterrupted(aim, pose, count);
        }
    }

    /** The next waypoint; null if there is none. */
    public synchronized Waypoint getWaypoint() {
        return path.isEmpty() ? null : path.get(0);
    }

    /** Whether no waypoint is left. */
    public synchronized boolean pathCompleted() {
        return path.isEmpty();
    }

    /** Waits until the path is no longer followed; returns whether no waypoint is left. */
    public synchronized boolean waitForStop() {
        boolean interrupted = false;
        while (going && Thread.currentThread() != driver) {
            interrupted |= !pause();
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
        return path.isEmpty();
    }

    /** Waits for a change; false if interrupted. */
    private boolean pause() {
        try {
            wait();
            return true;
        } catch (InterruptedException e) {
            return false;
        }
    }

    /** Whether a path is being followed. */
    public synchronized boolean isMoving() {
        return going;
    }

    /** Does nothing: a path that was found is not followed by itself. */
    @Override
    public void pathGenerated() {}

    /** The driver's whole life; it ends early if a pilot or a listener fails, and the next path gets another one. */
    private void driveOn() {
        try {
            while (true) {
                int number = awaitRun();
                Waypoint aim = nextDestination();
                if (aim != null) {
                    finish(aim, drive.driveTo(aim, poseProvider, () -> isGoing(number)));
                }
            }
        } finally {
            giveUp();
        }
    }

    private synchronized int awaitRun() {
        while (!going) {
            pause();
        }
        return run;
    }

    private synchronized Waypoint nextDestination() {
        if (path.isEmpty()) {
            going = false;
            notifyAll();
            return null;
        }
        destination = path.get(0);
        return destination;
    }

    private synchronized boolean isGoing(int number) {
        return going && run == number;
    }

    private synchronized void giveUp() {
        going = false;
        driver = null;
        notifyAll();
    }

    private void finish(Waypoint aim, WaypointDrive.Result result) {
        if (result == WaypointDrive.Result.ARRIVED) {
            int count = arrive(aim);
            tellArrived(aim, count);
            goOnOrRest();
        } else if (result == WaypointDrive.Result.NO_WAY) {
            stop();
        }
    }

    private synchronized int arrive(Waypoint aim) {
        if (!path.isEmpty() && path.get(0) == aim) {
            path.remove(0);
        }
        sequence++;
        return sequence;
    }

    private void tellArrived(Waypoint aim, int count) {
        Pose pose = poseProvider.getPose();
        for (NavigationListener listener : listeners) {
            listener.atWaypoint(aim, pose, count);
            if (pathCompleted()) {
                listener.pathComplete(aim, pose, count);
            }
        }
    }

    private synchronized void goOnOrRest() {
        going = going && !path.isEmpty() && !singleStep;
        notifyAll();
    }
}
