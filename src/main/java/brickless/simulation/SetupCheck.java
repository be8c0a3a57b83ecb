package brickless.simulation;

import brickless.physics.Arena;
import brickless.world.Obstacle;
import brickless.world.Point2;
import brickless.world.Pose2;
import brickless.world.World;
import brickless.world.Zone;
import java.awt.geom.Area;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Whether program, world, robots, goal and stimuli fit together; checked before anything is written. */
final class SetupCheck {
    /** Smaller overlaps, in metres across, are drawings that touch. */
    private static final double TOUCHING_METRES = 2e-3;

    private final SimulationSettings settings;
    private final World world;

    SetupCheck(SimulationSettings settings) {
        this.settings = settings;
        world = settings.world();
    }

    /** Throws a {@link SetupException} that names what is wrong and what is there. */
    void check(List<Crew.Member> crew, Arena arena) {
        settings.goal().flatMap(Goal::zone).ifPresent(this::zone);
        settings.stimuli().forEach(stimulus -> stimulus(stimulus, arena));
        crew.forEach(this::standsFree);
    }

    private void zone(String name) {
        List<String> zones = world.zones().stream().map(Zone::name).distinct().toList();
        if (!zones.contains(name)) {
            throw new SetupException("zone:" + name + ": " + worldName() + " has no such zone; "
                    + (zones.isEmpty() ? "it has no zones" : "its zones are " + String.join(", ", zones)));
        }
    }

    /** Checks that what a stimulus names is there. */
    static void stimulus(Stimulus stimulus, Arena arena) {
        String target = stimulus instanceof Stimulus.Move move ? move.target() : stimulus instanceof Stimulus.Remove remove ? remove.target() : null;
        if (target == null) {
            return;
        }
        boolean robot = arena.robot(target).isPresent() && stimulus instanceof Stimulus.Move;
        boolean movable = arena.obstacle(target).map(obstacle -> obstacle.description().movable()).orElse(false);
        if (!robot && !movable) {
            Stream<String> movables = arena.obstacles().stream().filter(obstacle -> obstacle.description().movable()).map(obstacle -> obstacle.name());
            Stream<String> robots = stimulus instanceof Stimulus.Move ? arena.robots().stream().map(r -> r.name()) : Stream.of();
            throw new SetupException("stimulus '" + stimulus.text() + "': there is nothing movable named " + target + "; there are: "
                    + Stream.concat(robots, movables).collect(Collectors.joining(", ")));
        }
    }

    private void standsFree(Crew.Member member) {
        for (Obstacle obstacle : world.obstacles()) {
            if (!obstacle.movable() && overlap(member, obstacle)) {
                throw new SetupException(worldName() + ": " + member.name() + ": the robot starts inside the obstacle " + obstacle.id()
                        + "; allowed: a start pose where " + member.model().name() + " stands free");
            }
        }
    }

    private static boolean overlap(Crew.Member member, Obstacle obstacle) {
        Area robot = area(member.model().chassis(), member.start());
        for (List<Point2> outline : obstacle.outlines()) {
            Area common = area(List.of(outline), new Pose2(0, 0, 0));
            common.intersect(robot);
            Rectangle2D bounds = common.getBounds2D();
            if (bounds.getWidth() > TOUCHING_METRES && bounds.getHeight() > TOUCHING_METRES) {
                return true;
            }
        }
        return false;
    }

    private static Area area(List<List<Point2>> outlines, Pose2 at) {
        double cos = StrictMath.cos(at.headingRadians());
        double sin = StrictMath.sin(at.headingRadians());
        Area area = new Area();
        for (List<Point2> outline : outlines) {
            Path2D path = new Path2D.Double();
            for (Point2 point : outline) {
                double x = at.x() + cos * point.x() - sin * point.y();
                double y = at.y() + sin * point.x() + cos * point.y();
                if (path.getCurrentPoint() == null) {
                    path.moveTo(x, y);
                } else {
                    path.lineTo(x, y);
                }
            }
            path.closePath();
            area.add(new Area(path));
        }
        return area;
    }

    private String worldName() {
        return settings.worldFile().isEmpty() ? world.name() : settings.worldFile();
    }
}
