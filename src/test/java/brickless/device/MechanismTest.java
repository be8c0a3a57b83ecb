package brickless.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import brickless.TestWorlds;
import brickless.hardware.MoveRequest;
import brickless.hardware.RegulationState;
import brickless.physics.Aim;
import brickless.physics.ArenaSettings;
import brickless.world.MotorType;
import brickless.world.Obstacle;
import brickless.world.Point2;
import brickless.world.Pose2;
import brickless.world.RobotModel;
import brickless.world.RobotModel.Claw;
import brickless.world.RobotModel.SensorMount;
import brickless.world.RobotModel.Turret;
import brickless.world.SensorType;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Turrets and claws. */
class MechanismTest {
    private static final int PORT_A = 0;
    private static final Point2 PIVOT = new Point2(0.02, 0);

    private static RobotModel withTurret(double gearRatio, boolean outlined) {
        List<List<Point2>> outlines = outlined ? List.of(TestWorlds.box(0, -0.02, 0.08, 0.02)) : List.of();
        Turret turret = new Turret("head", PORT_A, MotorType.MEDIUM, gearRatio, false, PIVOT, outlines);
        SensorMount eye = new SensorMount("eye", 0, SensorType.EV3_ULTRASONIC, new Point2(0.07, 0), 0, 0.06, List.of(),
                Optional.of("head"));
        RobotModel base = TestWorlds.educator();
        return new RobotModel("scanner", base.chassis(), base.massKilograms(), base.wheels(), base.casters(),
                List.of(eye), List.of(turret),
                List.of(), "");
    }

    private static RobotBench bench(RobotModel model, Obstacle... obstacles) {
        return new RobotBench(TestWorlds.with(obstacles), model, new Pose2(0, 0, 0), ArenaSettings.of(true));
    }

    private static void rotateTo(RobotBench bench, int degrees) {
        bench.devices.motor(PORT_A).move(new MoveRequest(200, 1000, degrees, true));
        bench.devices.motor(PORT_A).awaitStandstill();
        bench.runMillis(500);
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void turretTurnsLeftWithItsSensor(boolean outlined) {
        RobotBench bench = bench(withTurret(1, outlined));
        rotateTo(bench, 90);
        Aim aim = new Aim();
        bench.robot.aim(bench.robot.model().sensors().get(0), aim);
        assertThat(Math.toDegrees(aim.headingRadians)).isCloseTo(-90 + bench.headingDegrees(), offset(3.0));
        assertThat(aim.x).isCloseTo(0.02, offset(0.005));
        assertThat(aim.y).isCloseTo(-0.05, offset(0.005));
        assertThat(Math.toDegrees(bench.robot.turretAngleRadians(0))).isCloseTo(-90, offset(3.0));
    }

    @Test
    void gearedTurretTurnsLess() {
        RobotBench bench = bench(withTurret(3, true));
        rotateTo(bench, 270);
        assertThat(Math.toDegrees(bench.robot.turretAngleRadians(0))).isCloseTo(-90, offset(2.0));
    }

    @Test
    void turretStaysPutOnADrivingRobot() {
        RobotBench bench = bench(withTurret(1, true));
        rotateTo(bench, 45);
        bench.rotate(400, 100, 300);
        assertThat(Math.toDegrees(bench.robot.turretAngleRadians(0))).isCloseTo(-45, offset(3.0));
        assertThat(Math.toDegrees(bench.robot.shaft(PORT_A).angleRadians())).isCloseTo(45, offset(3.0));
    }

    @Test
    void turningTheTurretScansWalls() {
        RobotBench bench = bench(withTurret(1, true), TestWorlds.wall("left", -1, -0.6, 1, -0.55));
        bench.devices.sensor(0).uart().initialise(0);
        assertThat(distance(bench)).isEqualTo(2550);
        rotateTo(bench, 90);
        assertThat(distance(bench)).isCloseTo(500, offset(12));
    }

    private static int distance(RobotBench bench) {
        byte[] bytes = new byte[2];
        bench.devices.sensor(0).uart().read(bytes, 0, 2);
        return bytes[0] & 0xff | bytes[1] << 8;
    }

    @Test
    void blockedTurretBlocksItsMotor() {
        RobotBench bench = bench(withTurret(1, true), TestWorlds.wall("post", 0.056, -0.12, 0.09, -0.035));
        bench.devices.motor(PORT_A).move(new MoveRequest(200, 1000, 180, true));
        bench.devices.motor(PORT_A).awaitStandstill();
        assertThat(bench.devices.motor(PORT_A).state()).isEqualTo(RegulationState.STALL);
        assertThat(Math.toDegrees(bench.robot.turretAngleRadians(0))).isBetween(-95.0, -10.0);
    }

    private static RobotModel withClaw() {
        Claw claw = new Claw("claw", PORT_A, MotorType.MEDIUM, 0, 90, false, new Point2(0.06, 0),
                List.of(TestWorlds.box(0.05, -0.05, 0.11, -0.04), TestWorlds.box(0.05, 0.04, 0.11, 0.05)));
        RobotModel base = TestWorlds.educator();
        return new RobotModel("gripper", base.chassis(), base.massKilograms(), base.wheels(), base.casters(),
                List.of(), List.of(), List.of(claw), "");
    }

    @Test
    void closedClawCarriesACrateAndLetsGoWhenOpened() {
        RobotBench bench = bench(withClaw(), TestWorlds.crate("can", 0.085, 0, 0.04, 0.05));
        rotateTo(bench, 80);
        assertThat(bench.robot.held(0)).isPresent();
        bench.rotate(-300, -300, 300);
        double carried = bench.arena.obstacles().get(0).displacement().x();
        assertThat(carried).isCloseTo(bench.robot.xMetres(), offset(0.005));
        rotateTo(bench, 10);
        assertThat(bench.robot.held(0)).isEmpty();
        bench.rotate(-300, -300, 300);
        assertThat(bench.arena.obstacles().get(0).displacement().x()).isCloseTo(carried, offset(0.005));
    }

    @Test
    void openClawHoldsNothing() {
        RobotBench bench = bench(withClaw(), TestWorlds.crate("can", 0.085, 0, 0.04, 0.05));
        rotateTo(bench, 30);
        bench.rotate(-300, -300, 300);
        assertThat(bench.robot.held(0)).isEmpty();
        assertThat(bench.arena.obstacles().get(0).displacement().x()).isCloseTo(0, offset(0.002));
    }

    @Test
    void clawStopsAtItsLimits() {
        RobotBench bench = bench(withClaw());
        bench.devices.motor(PORT_A).drive(60);
        bench.runMillis(1500);
        assertThat(bench.devices.motor(PORT_A).encoder()).isEqualTo(90);
        bench.devices.motor(PORT_A).drive(-60);
        bench.runMillis(1500);
        assertThat(bench.devices.motor(PORT_A).encoder()).isZero();
    }

    @Test
    void removedObstacleIsNoLongerHeld() {
        RobotBench bench = bench(withClaw(), TestWorlds.crate("can", 0.085, 0, 0.04, 0.05));
        rotateTo(bench, 80);
        bench.arena.remove(bench.arena.obstacle("can").orElseThrow());
        bench.runMillis(100);
        assertThat(bench.robot.held(0)).isEmpty();
    }
}
