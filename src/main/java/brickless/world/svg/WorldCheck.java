package brickless.world.svg;

import brickless.units.Angles;
import brickless.units.Lengths;
import brickless.world.DescriptionException;
import brickless.world.Obstacle;
import brickless.world.Placement;
import brickless.world.Point2;
import brickless.world.Pose2;
import brickless.world.RobotModel;
import brickless.world.World;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.Polygon;

/** Checks that involve a world and a robot together. No state; safe for all threads. */
public final class WorldCheck {
    private static final GeometryFactory GEOMETRY = new GeometryFactory();

    private WorldCheck() {}

    /**
     * Checks that a robot can start where it is placed: on the drawing, on the table, and not inside an obstacle.
     *
     * @param world the arena
     * @param robot what stands there
     * @param start its pose
     * @throws DescriptionException naming the element that places the robot and what is in its way
     */
    public static void placement(World world, RobotModel robot, Pose2 start) throws DescriptionException {
        placement(world.name() + ".svg", world, robot, start);
    }

    /** The same, with the world's file as messages shall name it. */
    public static void placement(String file, World world, RobotModel robot, Pose2 start) throws DescriptionException {
        if (!(start.x() >= world.minX() && start.x() <= world.minX() + world.width() && start.y() >= world.minY()
                && start.y() <= world.minY() + world.height())) {
            throw problem(file, world, start, "the robot " + robot.name() + " starts outside the drawing, at "
                    + place(start));
        }
        for (RobotModel.Wheel wheel : robot.wheels()) {
            Point2 contact = moved(wheel.position(), start);
            if (world.table().isPresent() && !world.table().get().contains(contact.x(), contact.y())) {
                throw problem(file, world, start, "the wheel " + wheel.id() + " of the robot " + robot.name()
                        + " starts beside the table");
            }
        }
        List<Polygon> body = outlines(robot).stream()
                .map(outline -> polygon(outline.stream().map(p -> moved(p, start)).toList())).toList();
        Envelope around = new Envelope();
        body.forEach(part -> around.expandToInclude(part.getEnvelopeInternal()));
        for (Obstacle obstacle : world.obstacles()) {
            for (List<Point2> outline : obstacle.outlines()) {
                if (!around.intersects(envelope(outline))) {
                    continue;
                }
                Polygon solid = polygon(outline);
                if (body.stream().anyMatch(part -> part.intersects(solid) && !part.touches(solid))) {
                    throw problem(file, world, start, "the robot " + robot.name() + " starts inside the obstacle "
                            + obstacle.id() + ", at " + place(start)
                            + "; move one of them");
                }
            }
        }
    }

    private static List<List<Point2>> outlines(RobotModel robot) {
        List<List<Point2>> all = new ArrayList<>(robot.chassis());
        robot.turrets().forEach(turret -> all.addAll(turret.outlines()));
        robot.claws().forEach(claw -> all.addAll(claw.outlines()));
        robot.sensors().forEach(sensor -> all.add(sensor.outline()));
        all.removeIf(outline -> outline.size() < 3);
        return all;
    }

    private static DescriptionException problem(String file, World world, Pose2 start, String message)
            throws DescriptionException {
        Optional<Placement> placement = world.placements().stream().filter(one -> one.start().equals(start))
                .findFirst();
        if (placement.isPresent()) {
            SvgDocument document = SvgDocumentParser.parse(file, Optional.empty(), world.svg());
            SvgElement element = find(document.root(), placement.get().name());
            if (element != null) {
                return document.error(element, message);
            }
        }
        return new DescriptionException(file, 0, "", message);
    }

    private static SvgElement find(SvgElement element, String robot) {
        if (robot.equals(element.attribute("data-robot"))) {
            return element;
        }
        return element.children().stream().map(child -> find(child, robot)).filter(found -> found != null).findFirst()
                .orElse(null);
    }

    private static String place(Pose2 pose) {
        return "(" + Math.round(Lengths.millimetresFromMetres(pose.x())) + " mm, "
                + Math.round(Lengths.millimetresFromMetres(pose.y())) + " mm, "
                + Math.round(Angles.degreesFromRadians(pose.headingRadians())) + " degrees)";
    }

    private static Point2 moved(Point2 p, Pose2 pose) {
        double cos = StrictMath.cos(pose.headingRadians());
        double sin = StrictMath.sin(pose.headingRadians());
        return new Point2(pose.x() + cos * p.x() - sin * p.y(), pose.y() + sin * p.x() + cos * p.y());
    }

    private static Envelope envelope(List<Point2> ring) {
        Envelope envelope = new Envelope();
        for (Point2 p : ring) {
            envelope.expandToInclude(p.x(), p.y());
        }
        return envelope;
    }

    private static Polygon polygon(List<Point2> ring) {
        Coordinate[] coordinates = new Coordinate[ring.size() + 1];
        for (int i = 0; i < coordinates.length; i++) {
            Point2 p = ring.get(i % ring.size());
            coordinates[i] = new Coordinate(p.x(), p.y());
        }
        return GEOMETRY.createPolygon(coordinates);
    }
}
