package brickless.world.svg;

import static brickless.world.svg.Drawings.robot;
import static brickless.world.svg.Drawings.world;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import brickless.world.DescriptionException;
import brickless.world.Pose2;
import brickless.world.RobotModel;
import brickless.world.World;
import org.junit.jupiter.api.Test;

class WorldCheckTest {
    /** Chassis from −50 to 50 by −40 to 40 millimetres, wheels at ±60. */
    private static final RobotModel ROBOT = robot(
            "<rect id='l' data-part='wheel' data-port='B' x='-28' y='-74' width='56' height='28'/>"
            + "<rect id='r' data-part='wheel' data-port='C' x='-28' y='46' width='56' height='28'/>");

    private static String error(World world, Pose2 start) {
        return catchThrowableOfType(DescriptionException.class, () -> WorldCheck.placement(world, ROBOT, start))
                .getMessage();
    }

    @Test
    void robotBesideAWallIsFine() {
        World world = world("<rect data-solid='fixed' x='551' y='0' width='50' height='1000'/>");
        assertThatCode(() -> WorldCheck.placement(world, ROBOT, new Pose2(0.5, 0.5, 0))).doesNotThrowAnyException();
    }

    @Test
    void robotTouchingAWallIsFine() {
        World world = world("<rect data-solid='fixed' x='550' y='0' width='50' height='1000'/>");
        assertThatCode(() -> WorldCheck.placement(world, ROBOT, new Pose2(0.5, 0.5, 0))).doesNotThrowAnyException();
    }

    @Test
    void robotInAWallIsLocated() {
        World world = world("<rect id='wall' data-solid='fixed' x='549' y='0' width='50' height='1000'/>\n<g "
                + "id='start' data-robot='me' transform='translate(500,500)'/>");
        assertThat(error(world, new Pose2(0.5, 0.5, 0)))
                .isEqualTo("test.svg:3: start: the robot test starts inside the obstacle wall, at (500 mm, 500 mm, 0 "
                        + "degrees); move one of them");
    }

    @Test
    void robotAroundAThinPostAndWhollyInsideABlockAreFound() {
        World post = world("<circle id='post' data-solid='fixed' cx='510' cy='500' r='4'/>");
        assertThat(error(post, new Pose2(0.5, 0.5, 1)))
                .startsWith("test.svg: the robot test starts inside the obstacle post");
        World block = world("<rect id='block' data-solid='movable' width='1000' height='1000'/>");
        assertThat(error(block, new Pose2(0.5, 0.5, 1))).contains("inside the obstacle block");
    }

    @Test
    void turningTheRobotMayMakeItFit() {
        World lane = world("<rect data-solid='fixed' y='400' width='1000' height='55'/><rect data-solid='fixed' "
                + "y='545' width='1000' height='55'/>");
        assertThatCode(() -> WorldCheck.placement(lane, ROBOT, new Pose2(0.5, 0.5, 0))).doesNotThrowAnyException();
        assertThat(error(lane, new Pose2(0.5, 0.5, Math.PI / 2))).contains("90 degrees");
    }

    @Test
    void robotOutsideTheDrawing() {
        assertThat(error(world(""), new Pose2(1.2, 0.5, 0)))
                .contains("starts outside the drawing, at (1200 mm, 500 mm, 0 degrees)");
    }

    @Test
    void wheelBesideTheTable() {
        World table = world("<rect data-edge='cliff' width='1000' height='550'/>");
        assertThatCode(() -> WorldCheck.placement(table, ROBOT, new Pose2(0.5, 0.4, 0))).doesNotThrowAnyException();
        assertThat(error(table, new Pose2(0.5, 0.5, 0)))
                .contains("the wheel r of the robot test starts beside the table");
    }
}
