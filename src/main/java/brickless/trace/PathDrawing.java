package brickless.trace;

import brickless.world.Point2;
import brickless.world.Pose2;
import brickless.world.RobotModel;
import brickless.world.World;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Draws what happened into the world's own drawing ({@code path.svg}): driven paths, movable obstacles and robots where
 * they ended.
 *
 * <p>Feed it every sample; it keeps a point whenever a robot has moved more than 2 mm.
 */
public final class PathDrawing {
    private static final double SPACING_METRES = 0.002;
    private static final String[] COLOURS = {"#1769aa", "#b3261e", "#2e7d32", "#7b1fa2"};

    private final Map<String, List<Point2>> paths = new LinkedHashMap<>();
    private final Map<String, RobotSample> last = new LinkedHashMap<>();
    private final Map<String, Pose2> moved = new LinkedHashMap<>();

    /** Notes where everything is. */
    public void sample(Sample sample) {
        for (RobotSample robot : sample.robots()) {
            List<Point2> path = paths.computeIfAbsent(robot.name(), name -> new ArrayList<>());
            Point2 here = new Point2(robot.pose().x(), robot.pose().y());
            if (path.isEmpty() || distance(path.get(path.size() - 1), here) >= SPACING_METRES) {
                path.add(here);
            }
            last.put(robot.name(), robot);
        }
        for (BodySample body : sample.bodies()) {
            moved.put(body.id(), body.displacement());
        }
    }

    private static double distance(Point2 a, Point2 b) {
        return Math.sqrt((a.x() - b.x()) * (a.x() - b.x()) + (a.y() - b.y()) * (a.y() - b.y()));
    }

    /**
     * The picture as SVG text.
     *
     * @param world the arena
     * @param models what each robot is built of, by its name
     */
    public String svg(World world, Map<String, RobotModel> models) {
        StringBuilder extra = new StringBuilder(
                "<g id=\"brickless-run\" fill=\"none\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n");
        world.obstacles().stream().filter(obstacle -> moved.containsKey(obstacle.id())).forEach(obstacle -> {
            appendOutlines(extra, obstacle.outlines(), moved.get(obstacle.id()),
                    "stroke=\"#5d4037\" stroke-width=\"3\" fill=\"#a1887f\" fill-opacity=\"0.75\"");
        });
        int index = 0;
        for (Map.Entry<String, List<Point2>> path : paths.entrySet()) {
            String colour = COLOURS[index++ % COLOURS.length];
            extra.append("<polyline stroke=\"").append(colour)
                    .append("\" stroke-width=\"4\" stroke-opacity=\"0.8\" points=\"");
            path.getValue().forEach(point -> extra.append(millimetres(point.x())).append(',')
                    .append(millimetres(point.y())).append(' '));
            extra.append("\"/>\n");
            Point2 start = path.getValue().get(0);
            extra.append("<circle cx=\"").append(millimetres(start.x())).append("\" cy=\"")
                    .append(millimetres(start.y()))
                    .append("\" r=\"10\" stroke=\"").append(colour)
                    .append("\" stroke-width=\"4\" fill=\"#ffffff\"/>\n");
            RobotSample end = last.get(path.getKey());
            List<List<Point2>> body = models.containsKey(path.getKey())
                    ? RobotOutline.of(models.get(path.getKey()), end.motors()) : List.of();
            appendOutlines(extra, body, end.pose(),
                    "stroke=\"" + colour + "\" stroke-width=\"4\" fill=\"" + colour + "\" fill-opacity=\"0.25\"");
            appendNose(extra, end.pose(), colour);
        }
        extra.append("</g>\n");
        int tag = world.svg().lastIndexOf("</svg>");
        int at = tag < 0 ? closingTag(world.svg()) : tag;
        return world.svg().substring(0, at) + extra + world.svg().substring(at);
    }

    private static int closingTag(String svg) {
        return Math.max(0, svg.lastIndexOf("</"));
    }

    private static void appendOutlines(StringBuilder out, List<List<Point2>> outlines, Pose2 pose, String style) {
        double cos = StrictMath.cos(pose.headingRadians());
        double sin = StrictMath.sin(pose.headingRadians());
        for (List<Point2> ring : outlines) {
            out.append("<polygon ").append(style).append(" points=\"");
            for (Point2 p : ring) {
                out.append(millimetres(pose.x() + p.x() * cos - p.y() * sin)).append(',')
                        .append(millimetres(pose.y() + p.x() * sin + p.y() * cos)).append(' ');
            }
            out.append("\"/>\n");
        }
    }

    private static void appendNose(StringBuilder out, Pose2 pose, String colour) {
        double length = 0.08;
        out.append("<line stroke=\"").append(colour).append("\" stroke-width=\"6\" x1=\"").append(millimetres(pose.x()))
                .append("\" y1=\"")
                .append(millimetres(pose.y())).append("\" x2=\"")
                .append(millimetres(pose.x() + length * StrictMath.cos(pose.headingRadians())))
                .append("\" y2=\"").append(millimetres(pose.y() + length * StrictMath.sin(pose.headingRadians())))
                .append("\"/>\n");
    }

    private static String millimetres(double metres) {
        return Decimals.text(metres * 1000, 2);
    }
}
