package brickless.trace;

import brickless.units.Angles;
import brickless.world.Obstacle;
import brickless.world.Point2;
import brickless.world.RobotModel;
import brickless.world.RobotModel.Claw;
import brickless.world.World;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * What a report draws a run with.
 *
 * @param world the arena; its drawing should hold its images
 * @param robots what each robot of the run is built of, by its name in the world
 */
public record ReportScene(World world, Map<String, RobotModel> robots) {
    public ReportScene {
        robots = new LinkedHashMap<>(robots);
    }

    /** Writes the fields of the scene. */
    public void write(JsonLine line) {
        line.text("svg", world.svg());
        line.raw("bounds", "[" + millimetres(world.minX()) + "," + millimetres(world.minY()) + ","
                + millimetres(world.width()) + "," + millimetres(world.height()) + "]");
        List<Obstacle> movable = world.obstacles().stream().filter(Obstacle::movable).toList();
        line.objects("bodies", movable, (body, fields) -> fields.text("id", body.id())
                .raw("outlines", outlines(body.outlines())));
        line.objects("robots", robots.entrySet(), (robot, fields) -> robot(robot.getKey(), robot.getValue(), fields));
    }

    private static void robot(String name, RobotModel model, JsonLine line) {
        line.text("name", name).text("svg", model.svg()).raw("outlines", outlines(model.chassis()));
        line.objects("turrets", model.turrets(), (turret, fields) -> fields.text("id", turret.id())
                .text("port", String.valueOf((char) ('A' + turret.port()))).raw("pivot", point(turret.pivot()))
                .number("ratio", RobotOutline.turnsPerMotorTurn(turret), 6));
        line.objects("claws", model.claws(), ReportScene::claw);
    }

    private static void claw(Claw claw, JsonLine line) {
        int sign = claw.inverted() ? -1 : 1;
        line.text("id", claw.id()).text("port", String.valueOf((char) ('A' + claw.port())))
                .raw("pivot", point(claw.pivot()))
                .number("open", sign * claw.minDegrees(), 2).number("closed", sign * claw.maxDegrees(), 2);
        line.objects("jaws", Jaw.of(claw), (jaw, fields) -> fields.number("side", jaw.side(), 0)
                .raw("hinge", point(jaw.hinge())).number("degrees", Angles.degreesFromRadians(jaw.closedRadians()), 2));
    }

    private static String outlines(List<List<Point2>> outlines) {
        List<String> rings = new ArrayList<>();
        for (List<Point2> ring : outlines) {
            rings.add("[" + String.join(",", ring.stream().map(ReportScene::point).toList()) + "]");
        }
        return "[" + String.join(",", rings) + "]";
    }

    private static String point(Point2 point) {
        return "[" + millimetres(point.x()) + "," + millimetres(point.y()) + "]";
    }

    private static String millimetres(double metres) {
        return Decimals.text(metres * 1000, 2);
    }
}
