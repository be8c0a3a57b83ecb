package brickless.trace;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import brickless.trace.RobotSample.MotorSample;
import brickless.world.MotorType;
import brickless.world.Point2;
import brickless.world.Pose2;
import brickless.world.RobotModel;
import brickless.world.RobotModel.Claw;
import brickless.world.RobotModel.Turret;
import brickless.world.World;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Turrets and jaws are drawn where their motors have turned them. */
class RobotOutlineTest {
    private static final List<Point2> CHASSIS = box(-0.1, -0.05, 0.05, 0.05);
    private static final List<Point2> LEFT_JAW = box(0.05, -0.05, 0.11, -0.04);
    private static final List<Point2> RIGHT_JAW = box(0.05, 0.04, 0.11, 0.05);
    private static final List<Point2> CROSSBAR = box(0.05, -0.05, 0.06, 0.05);

    private static List<Point2> box(double left, double top, double right, double bottom) {
        return List.of(new Point2(left, top), new Point2(right, top), new Point2(right, bottom),
                new Point2(left, bottom));
    }

    private static RobotModel robot(List<Turret> turrets, List<Claw> claws) {
        return new RobotModel("robot", List.of(CHASSIS), 0.8, List.of(), List.of(), List.of(), turrets, claws, "");
    }

    private static RobotModel clawed(boolean inverted) {
        return robot(List.of(), List.of(new Claw("claw", 0, MotorType.MEDIUM, 0, 90, inverted, new Point2(0.05, 0),
                List.of(LEFT_JAW, RIGHT_JAW, CROSSBAR))));
    }

    private static List<List<Point2>> at(RobotModel model, double tachoDegrees) {
        return RobotOutline.of(model, List.of(new MotorSample('A', tachoDegrees, 0, 0, 0)));
    }

    private static double innermost(List<Point2> ring) {
        return ring.stream().mapToDouble(p -> Math.abs(p.y())).min().orElseThrow();
    }

    @Test
    void openClawIsDrawnAsInItsFile() {
        assertThat(at(clawed(false), 0)).containsExactly(CHASSIS, LEFT_JAW, RIGHT_JAW, CROSSBAR);
        assertThat(RobotOutline.of(clawed(false), List.of())).as("without its motor").contains(LEFT_JAW);
    }

    @ParameterizedTest
    @CsvSource({"45,false", "90,false", "-90,true", "200,false"})
    void jawsSwingInwardsTogether(double tacho, boolean inverted) {
        List<List<Point2>> outlines = at(clawed(inverted), tacho);
        assertThat(outlines.get(0)).isEqualTo(CHASSIS);
        assertThat(outlines.get(3)).as("what spans the middle").isEqualTo(CROSSBAR);
        assertThat(innermost(outlines.get(1))).isBetween(0.005, 0.035);
        for (int i = 0; i < 4; i++) {
            Point2 left = outlines.get(1).get(i);
            Point2 right = outlines.get(2).get(3 - i);
            assertThat(left.x()).isCloseTo(right.x(), within(1e-9));
            assertThat(left.y()).isCloseTo(-right.y(), within(1e-9));
        }
    }

    @Test
    void jawsCloseNoFurtherThanTheirStop() {
        assertThat(at(clawed(false), 500)).isEqualTo(at(clawed(false), 90));
        assertThat(at(clawed(false), -30)).isEqualTo(at(clawed(false), 0));
    }

    /**
     * Forward of the motor turns a turret to the left, which is up the page; a quarter turn through a gear of 2 is an
     * eighth.
     */
    @ParameterizedTest
    @CsvSource({"90,1,false,0,-0.05", "90,1,true,0,0.05", "180,2,false,0,-0.05", "-90,1,false,0,0.05"})
    void turretsTurnLeft(double tacho, double gearRatio, boolean inverted, double x, double y) {
        Turret turret = new Turret("head", 0, MotorType.MEDIUM, gearRatio, inverted, new Point2(0, 0),
                List.of(List.of(new Point2(0.05, 0), new Point2(0.05, 0.001), new Point2(0.049, 0))));
        Point2 nose = at(robot(List.of(turret), List.of()), tacho).get(1).get(0);
        assertThat(nose.x()).isCloseTo(x, within(1e-9));
        assertThat(nose.y()).isCloseTo(y, within(1e-9));
    }

    @Test
    void pathDrawingShowsClosedJawsAtTheEnd() {
        PathDrawing drawing = new PathDrawing();
        drawing.sample(new Sample(0,
                List.of(new RobotSample("robot", new Pose2(0, 0, 0), List.of(new MotorSample('A', 0, 0, 0, 0)),
                List.of(), 8)), List.of()));
        World world = new World("hall", 0, 0, 2, 1, List.of(), List.of(), List.of(), List.of(), List.of(),
                Optional.empty(), List.of(), "<svg></svg>");
        String open = drawing.svg(world, Map.of("robot", clawed(false)));
        assertThat(open).contains("50,40 110,40");
        drawing.sample(new Sample(1,
                List.of(new RobotSample("robot", new Pose2(0, 0, 0), List.of(new MotorSample('A', 90, 0, 0, 0)),
                List.of(), 8)), List.of()));
        assertThat(drawing.svg(world, Map.of("robot", clawed(false)))).doesNotContain("110,40");
    }
}
