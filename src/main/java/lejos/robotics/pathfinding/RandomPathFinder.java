package lejos.robotics.pathfinding;

import java.util.Random;
import lejos.robotics.RangeReading;
import lejos.robotics.RangeReadings;
import lejos.robotics.geometry.Point;
import lejos.robotics.geometry.Rectangle;
import lejos.robotics.mapping.RangeMap;
import lejos.robotics.navigation.DestinationUnreachableException;
import lejos.robotics.navigation.Pose;
import lejos.robotics.navigation.Waypoint;
import lejos.robotics.navigation.WaypointListener;

/**
 * Finds paths from one random pose to the next, each in sight of the one before, nearer to the destination and with
 * walls in reach of a range finder at all angles of a template. Only poses are kept from which a robot can locate
 * itself.
 */
public class RandomPathFinder implements PathFinder {
    /** Chance; tests of this package choose its seed. */
    static final Random RANDOM = new Random();

    private static final float LEAST_GAIN = 1;
    private static final float FULL_TURN = 360;

    private final RangeMap map;
    private final RangeReadings template;
    private final WaypointListeners listeners = new WaypointListeners();
    private float maxRange = 150;
    private float maxDistance = 200;
    private float clearance = 20;
    private int maxIterations = 1000;

    /**
     * A finder.
     *
     * @param map the walls
     * @param readings readings whose angles matter
     */
    public RandomPathFinder(RangeMap map, RangeReadings readings) {
        this.map = map;
        this.template = readings;
    }

    /** Sets the greatest distance of walls from poses on the way; 150 unless set. */
    public void setMaxRange(float range) {
        maxRange = range;
    }

    /** Sets the greatest distance of one pose from the next; 200 unless set. */
    public void setMaxDistance(float distance) {
        maxDistance = distance;
    }

    /** Sets how many random poses to try for each step; 1000 unless set. */
    public void setMaxIterations(int iterations) {
        maxIterations = iterations;
    }

    /** Sets the least distance of poses from the edge of the map; 20 unless set. */
    public void setClearance(float clearance) {
        this.clearance = clearance;
    }

    /** A path, which does not contain the start. */
    @Override
    public Path findRoute(Pose start, Waypoint destination) throws DestinationUnreachableException {
        Path path = new Path();
        Pose pose = new Pose(start.getX(), start.getY(), start.getHeading());
        while (!inSight(pose, destination)) {
            pose = nextPose(pose, destination);
            path.add(new Waypoint(pose));
        }
        path.add(new Waypoint(destination));
        return path;
    }

    @Override
    public void addListener(WaypointListener wl) {
        listeners.add(wl);
    }

    @Override
    public void startPathFinding(Pose start, Waypoint end) {
        Path path;
        try {
            path = findRoute(start, end);
        } catch (DestinationUnreachableException e) {
            return; // the contract: no path, no calls
        }
        listeners.tell(path);
    }

    private Pose nextPose(Pose from, Point destination) throws DestinationUnreachableException {
        for (int i = 0; i < maxIterations; i++) {
            Pose pose = randomPose();
            boolean nearer = pose.distanceTo(destination) <= from.distanceTo(destination) - LEAST_GAIN;
            Point place = pose.getLocation();
            if (nearer && map.inside(place) && allRangesInReach(pose) && inSight(from, place)) {
                return pose;
            }
        }
        throw new DestinationUnreachableException();
    }

    private Pose randomPose() {
        Rectangle area = map.getBoundingRect();
        float x = area.x + clearance + RANDOM.nextFloat() * (area.width - 2 * clearance);
        float y = area.y + clearance + RANDOM.nextFloat() * (area.height - 2 * clearance);
        return new Pose(x, y, RANDOM.nextFloat() * FULL_TURN);
    }

    private boolean allRangesInReach(Pose pose) {
        for (RangeReading reading : template) {
            float range = map.range(new Pose(pose.getX(), pose.getY(), pose.getHeading() + reading.getAngle()));
            if (range < 0 || range > maxRange) {
                return false;
            }
        }
        return true;
    }

    /** Whether the point is near enough and the map, which must see a wall in that direction, sees none before it. */
    private boolean inSight(Pose from, Point to) {
        float distance = from.distanceTo(to);
        float range = map.range(new Pose(from.getX(), from.getY(), from.angleTo(to)));
        return distance <= maxDistance && range >= distance;
    }
}
