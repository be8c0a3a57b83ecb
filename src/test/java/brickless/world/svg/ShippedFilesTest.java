package brickless.world.svg;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import brickless.world.DescriptionException;
import brickless.world.Floor;
import brickless.world.Obstacle;
import brickless.world.Placement;
import brickless.world.Point2;
import brickless.world.RobotModel;
import brickless.world.RobotModel.SensorMount;
import brickless.world.RobotModel.Wheel;
import brickless.world.World;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

/** The worlds and robots of the repository. */
class ShippedFilesTest {
    private static World world(String name) throws DescriptionException {
        return SvgWorldReader.read(Shipped.file("sim/worlds/" + name + ".svg"));
    }

    private static RobotModel robot(String name) throws DescriptionException {
        return SvgRobotReader.read(Shipped.file("sim/robots/" + name + ".svg"));
    }

    @Test
    void allAreThere() {
        assertThat(Shipped.worlds()).extracting(path -> path.getFileName().toString())
                .contains("pen.svg", "line-loop.svg", "maze.svg", "corridor.svg",
                "obstacle-course.svg", "line-crossings.svg", "colour-tiles.svg", "table-top.svg", "sumo-ring.svg",
                        "beacon-room.svg", "can-field.svg",
                "lamp-room.svg");
        assertThat(Shipped.robots()).extracting(path -> path.getFileName().toString())
                .contains("educator.svg", "tribot-caster.svg", "medium-turret.svg",
                "gripper.svg", "tracked.svg", "sumo.svg", "three-wheel-holonomic.svg");
    }

    /** Every robot fits into every start place, so that any program and robot can be tried in any world. */
    @TestFactory
    Stream<DynamicTest> everyRobotFitsIntoEveryStartPlace() {
        return Shipped.worlds().stream().map(path -> DynamicTest.dynamicTest(path.getFileName().toString(), () -> {
            World world = SvgWorldReader.read(path);
            assertThat(world.placements()).isNotEmpty();
            for (Placement placement : world.placements()) {
                for (Path robot : Shipped.robots()) {
                    WorldCheck.placement(path.toString(), world, SvgRobotReader.read(robot), placement.start());
                }
            }
        }));
    }

    @TestFactory
    Stream<DynamicTest> everyRobotStandsOnItsWheelsAndCasters() {
        return Shipped.robots().stream().map(path -> DynamicTest.dynamicTest(path.getFileName().toString(), () -> {
            RobotModel robot = SvgRobotReader.read(path);
            List<Point2> supports = Stream.concat(robot.wheels().stream().map(Wheel::position),
                    robot.casters().stream().map(RobotModel.Caster::position)).toList();
            assertThat(supports).hasSizeGreaterThanOrEqualTo(3);
            assertThat(robot.massKilograms()).isBetween(0.7, 1.2);
            assertThat(robot.sensors()).extracting(SensorMount::port).doesNotHaveDuplicates();
        }));
    }

    @Test
    void educatorIsTheUsualRobot() throws DescriptionException {
        RobotModel robot = robot("educator");
        assertThat(robot.massKilograms()).isEqualTo(0.75);
        assertThat(robot.wheels()).extracting(Wheel::port).containsExactly(1, 2);
        assertThat(robot.wheels()).extracting(Wheel::diameterMetres).containsOnly(0.056);
        assertThat(robot.wheels().get(1).position().y() - robot.wheels().get(0).position().y()).as("track")
                .isCloseTo(0.12, within(1e-9));
        assertThat(robot.sensors().stream().map(sensor -> sensor.port() + " " + sensor.type().attribute()))
                .containsExactlyInAnyOrder("0 ev3-touch", "1 ev3-gyro", "2 ev3-color", "3 ev3-ultrasonic");
    }

    @Test
    void penHasWallsBoxesAndAGoalThatIsPainted() throws DescriptionException {
        World pen = world("pen");
        assertThat(new double[] {pen.width(), pen.height()}).containsExactly(2, 1.5);
        assertThat(pen.obstacles().stream().filter(Obstacle::movable)).hasSizeGreaterThanOrEqualTo(5);
        assertThat(pen.obstacles().stream().filter(Obstacle::movable).map(Obstacle::massKilograms).distinct())
                .hasSizeGreaterThanOrEqualTo(5);
        assertThat(pen.zones().get(0).region().contains(1.56, 1.2)).isTrue();
        assertThat(new Floor(pen).rgbAt(1.545, 1.2)).isEqualTo(0x9FD8A4);
    }

    @Test
    void lineOfTheLoopIsBlackTapeOnWhite() throws DescriptionException {
        Floor floor = new Floor(world("line-loop"));
        assertThat(floor.rgbAt(1.2, 1.25)).isZero();
        assertThat(floor.rgbAt(1.2, 1.2415)).isZero();
        assertThat(floor.rgbAt(1.2, 1.2395)).isEqualTo(0xFFFFFF);
        assertThat(floor.rgbAt(2.0, 0.9)).as("top of the wide bend").isZero();
        assertThat(floor.rgbAt(1.0, 0.9)).isEqualTo(0xFFFFFF);
    }

    @Test
    void tableTopHasAnEdgeAndTheSumoRingToo() throws DescriptionException {
        assertThat(new Floor(world("table-top")).rgbAt(0.05, 0.05)).isEqualTo(Floor.NO_FLOOR);
        assertThat(new Floor(world("sumo-ring")).rgbAt(0, 0.58)).isEqualTo(0xF7F7F4);
        assertThat(new Floor(world("sumo-ring")).rgbAt(0, 0.61)).isEqualTo(Floor.NO_FLOOR);
    }

    @Test
    void turretCarriesBothEyes() throws DescriptionException {
        RobotModel robot = robot("medium-turret");
        assertThat(robot.sensors().stream().filter(sensor -> sensor.turret().isPresent())).hasSize(2);
        assertThat(robot.turrets().get(0).pivot()).isEqualTo(new Point2(0.058, 0));
    }

    @Test
    void holonomicWheelsRollAroundTheMiddle() throws DescriptionException {
        for (Wheel wheel : robot("three-wheel-holonomic").wheels()) {
            double radial = StrictMath.cos(wheel.headingRadians()) * wheel.position().x()
                    + StrictMath.sin(wheel.headingRadians()) * wheel.position().y();
            assertThat(wheel.omni()).isTrue();
            assertThat(radial).as(wheel.id()).isCloseTo(0, within(1e-9));
            assertThat(Math.hypot(wheel.position().x(), wheel.position().y())).isCloseTo(0.092, within(1e-9));
        }
    }
}
