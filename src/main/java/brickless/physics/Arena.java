package brickless.physics;

import brickless.world.Obstacle;
import brickless.world.Pose2;
import brickless.world.World;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;

/**
 * A world with robots in it, computed in fixed steps.
 *
 * <p>Not thread safe: the simulation and whoever reads between steps synchronise on the arena.
 */
public final class Arena {
    private static final double NANOS_PER_SECOND = 1e9;

    private final World description;
    private final LeanWorld world;
    private final List<RobotBody> robots;
    private final List<ObstacleBody> obstacles;
    private final Contacts contacts;
    private final Sector sector;
    private final Aim line = new Aim();
    private final ZoneWatch zones;
    private final SoundField sound = new SoundField();
    private final ArenaSettings settings;
    private final double stepSeconds;
    private final long stepNanos;
    private ArenaListener listener = ArenaListener.NONE;
    private long now;

    /** Builds the arena; robots keep their order. */
    public Arena(World description, List<Entrant> entrants, ArenaSettings settings) {
        Decimetres.use();
        this.description = description;
        this.settings = settings;
        this.stepNanos = settings.stepNanos();
        this.stepSeconds = stepNanos / NANOS_PER_SECOND;
        this.world = new LeanWorld();
        Body ground = world.createBody(new BodyDef());
        List<ObstacleBody> solids = new ArrayList<>();
        for (Obstacle obstacle : description.obstacles()) {
            solids.add(new ObstacleBody(world, ground, obstacle));
        }
        List<RobotBody> bodies = new ArrayList<>();
        for (Entrant entrant : entrants) {
            bodies.add(new RobotBody(world, ground, entrant, bodies.size(), settings.ideal(), solids.size()));
        }
        this.obstacles = List.copyOf(solids);
        this.robots = List.copyOf(bodies);
        this.contacts = new Contacts(robots.size());
        this.sector = new Sector(world);
        this.zones = new ZoneWatch(description.zones(), robots.size());
        world.setContactListener(contacts);
    }

    /** What was drawn. */
    public World description() {
        return description;
    }

    /** Length of a step in nanoseconds. */
    public long stepNanos() {
        return stepNanos;
    }

    /** Robots in the order in which they were given. */
    public List<RobotBody> robots() {
        return robots;
    }

    /** Obstacles in drawing order, removed ones included. */
    public List<ObstacleBody> obstacles() {
        return obstacles;
    }

    /** The sound in the arena. */
    public SoundField sound() {
        return sound;
    }

    /** Who is told about collisions, zones and falls; replaces the former one. */
    public void setListener(ArenaListener newListener) {
        listener = newListener;
        contacts.setListener(newListener);
    }

    /** Computes one step. Motors must have been set before; sensors may be read after. */
    public void step() {
        now += stepNanos;
        contacts.begin(now);
        for (int i = 0; i < robots.size(); i++) {
            robots.get(i).prepare(stepSeconds);
        }
        world.step((float) stepSeconds, settings.velocityIterations(), settings.positionIterations());
        for (int i = 0; i < robots.size(); i++) {
            finish(robots.get(i));
        }
    }

    private void finish(RobotBody robot) {
        robot.finish(stepSeconds);
        zones.check(robot, listener);
        if (description.table().isPresent() && robot.fallsOff(description.table().get())) {
            listener.fell(robot);
        }
    }

    /**
     * Casts a ray.
     *
     * @param aim where it starts and its direction
     * @param turnRadians added to the direction
     * @param reachMetres its length
     * @param leastHeightMetres lower obstacles are passed over
     * @param own the robot that casts it, which it ignores; may be null
     * @param out receives the nearest hit
     */
    public void castRay(Aim aim, double turnRadians, double reachMetres, double leastHeightMetres, RobotBody own,
            RayHit out) {
        line.x = aim.x;
        line.y = aim.y;
        line.headingRadians = aim.headingRadians + turnRadians;
        sector.see(leastHeightMetres, own);
        sector.face(line, 1, 0, reachMetres, 0);
        sector.cast(0, 1, 0, out);
    }

    /** What is in front of whoever looks; used for one place after the other. */
    Sector sector() {
        return sector;
    }

    /** The obstacle with an id, if it is still there. */
    public Optional<ObstacleBody> obstacle(String id) {
        return obstacles.stream().filter(o -> o.name().equals(id) && o.present()).findFirst();
    }

    /** The robot with a name. */
    public Optional<RobotBody> robot(String name) {
        return robots.stream().filter(r -> r.name().equals(name)).findFirst();
    }

    /** Moves a robot by hand: it is at rest at the new place and lets go of what it held. */
    public void move(RobotBody robot, Pose2 pose) {
        robot.place(pose);
    }

    /** Moves an obstacle by hand: its centroid to the pose, turned by the heading against how it was drawn. */
    public void move(ObstacleBody obstacle, Pose2 pose) {
        robots.forEach(robot -> robot.release(obstacle));
        obstacle.place(pose);
    }

    /** Takes an obstacle away for good. */
    public void remove(ObstacleBody obstacle) {
        robots.forEach(robot -> robot.release(obstacle));
        obstacle.remove();
    }
}
