package brickless.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;
import static org.assertj.core.data.Percentage.withPercentage;

import brickless.TestWorlds;
import brickless.physics.ArenaSettings;
import brickless.world.MotorType;
import brickless.world.Point2;
import brickless.world.Pose2;
import brickless.world.RobotModel;
import brickless.world.RobotModel.Wheel;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A two-wheeled robot on open floor. */
class DrivingTest {
    private static final double CIRCUMFERENCE = Math.PI * 0.056;
    private static final int ONE_METRE = (int) Math.round(360 / CIRCUMFERENCE);
    private static final int QUARTER_TURN = (int) Math.round(90 * 0.114 / 0.056);

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void straightMetreIsAMetre(boolean ideal) {
        RobotBench bench = ideal ? RobotBench.ideal(TestWorlds.with(), TestWorlds.educator())
                : RobotBench.real(TestWorlds.with(), TestWorlds.educator());
        bench.rotate(ONE_METRE, ONE_METRE, 360);
        assertThat(bench.robot.xMetres()).isCloseTo(1, withPercentage(1));
        assertThat(bench.robot.yMetres()).isCloseTo(0, offset(0.002));
        assertThat(bench.headingDegrees()).isCloseTo(0, offset(0.2));
        assertThat(bench.robot.distanceMetres()).isBetween(1.0, 1.02);
    }

    @Test
    void idealSquareClosesWithinOnePercentAndOneDegree() {
        RobotBench bench = RobotBench.ideal(TestWorlds.with(), TestWorlds.educator());
        square(bench);
        assertThat(bench.robot.xMetres()).isCloseTo(0, offset(0.01));
        assertThat(bench.robot.yMetres()).isCloseTo(0, offset(0.01));
        assertThat(bench.headingDegrees()).isCloseTo(4.0 * QUARTER_TURN * 0.056 / 0.114, offset(1.0));
    }

    @Test
    void tyresLoseALittleOfEveryTurn() {
        RobotBench bench = RobotBench.real(TestWorlds.with(), TestWorlds.educator());
        square(bench);
        assertThat(bench.headingDegrees()).isBetween(355.0, 360.5);
    }

    private static void square(RobotBench bench) {
        for (int i = 0; i < 4; i++) {
            bench.rotate(ONE_METRE, ONE_METRE, 360);
            bench.rotate(QUARTER_TURN, -QUARTER_TURN, 180);
        }
    }

    @Test
    void forwardOfTheLeftWheelTurnsRight() {
        RobotBench bench = RobotBench.real(TestWorlds.with(), TestWorlds.educator());
        bench.drive(50, 0);
        bench.runMillis(1000);
        assertThat(bench.headingDegrees()).isPositive();
        assertThat(bench.robot.yMetres()).isPositive();
    }

    @Test
    void parkedRobotDoesNotMoveAtAll() {
        RobotBench bench = RobotBench.real(TestWorlds.with(), TestWorlds.educator());
        bench.drive(60, 40);
        bench.runMillis(1000);
        bench.drive(0, 0);
        bench.runMillis(2000);
        Pose2 parked = bench.robot.pose();
        bench.runMillis(10_000);
        assertThat(bench.robot.pose()).isEqualTo(parked);
    }

    @Test
    void coastingRobotRollsFurtherThanABrakingOne() {
        RobotBench coasting = RobotBench.real(TestWorlds.with(), TestWorlds.educator());
        RobotBench braking = RobotBench.real(TestWorlds.with(), TestWorlds.educator());
        for (RobotBench bench : List.of(coasting, braking)) {
            bench.drive(80, 80);
            bench.runMillis(1000);
        }
        coasting.devices.motor(RobotBench.LEFT).coast();
        coasting.devices.motor(RobotBench.RIGHT).coast();
        braking.drive(0, 0);
        coasting.runMillis(2000);
        braking.runMillis(2000);
        assertThat(coasting.robot.distanceMetres()).isGreaterThan(braking.robot.distanceMetres() + 0.02);
    }

    @Test
    void reversingAtFullSpeedSlipsOnlyOnRealTyres() {
        assertThat(slipAfterReversing(true)).isCloseTo(0, offset(0.001));
        assertThat(slipAfterReversing(false)).isLessThan(-0.01);
    }

    private static double slipAfterReversing(boolean ideal) {
        RobotBench bench = new RobotBench(TestWorlds.with(), TestWorlds.educator(), new Pose2(0, 0, 0),
                ArenaSettings.of(ideal));
        bench.drive(100, 100);
        bench.runMillis(500);
        bench.drive(-100, -100);
        bench.runMillis(500);
        return bench.robot.shaft(RobotBench.LEFT).angleRadians() * 0.028 - bench.robot.xMetres();
    }

    @Test
    void invertedGearedWheelsDriveByTheirRatio() {
        List<Wheel> wheels = List.of(
                new Wheel("l", 1, MotorType.LARGE, 0.056, 2, true, new Point2(0, -0.057), 0, false),
                new Wheel("r", 2, MotorType.LARGE, 0.056, 2, true, new Point2(0, 0.057), 0, false));
        RobotBench bench = RobotBench.ideal(TestWorlds.with(), TestWorlds.robot(wheels, List.of()));
        bench.rotate(720, 720, 360);
        assertThat(bench.robot.xMetres()).isCloseTo(-CIRCUMFERENCE, withPercentage(1));
    }

    @Test
    void threeOmniWheelsDriveSideways() {
        RobotModel model = omniRobot();
        RobotBench bench = RobotBench.ideal(TestWorlds.with(), model);
        double[] sideways = {Math.sin(0), Math.sin(Math.toRadians(120)), Math.sin(Math.toRadians(240))};
        for (int port = 0; port < 3; port++) {
            bench.devices.motor(port).drive((int) Math.round(60 * sideways[port]));
        }
        bench.runMillis(1500);
        assertThat(bench.robot.yMetres()).isGreaterThan(0.1);
        assertThat(bench.robot.xMetres()).isCloseTo(0, offset(0.02));
        assertThat(bench.headingDegrees()).isCloseTo(0, offset(3.0));
    }

    private static RobotModel omniRobot() {
        List<Wheel> wheels = new ArrayList<>();
        for (int port = 0; port < 3; port++) {
            double heading = Math.toRadians(120 * port);
            wheels.add(new Wheel("w" + port, port, MotorType.LARGE, 0.05, 1, false,
                    new Point2(-0.08 * Math.sin(heading), 0.08 * Math.cos(heading)), heading, true));
        }
        return new RobotModel("omni", List.of(TestWorlds.box(-0.07, -0.07, 0.07, 0.07)), 0.8, wheels, List.of(),
                List.of(), List.of(), List.of(), "");
    }

    @Test
    void halvingTheStepChangesTheEndByLessThanOnePercent() {
        Pose2 fine = curve(1_000_000);
        Pose2 usual = curve(ArenaSettings.DEFAULT_STEP_NANOS);
        double length = 1.0;
        assertThat(Math.hypot(usual.x() - fine.x(), usual.y() - fine.y())).isLessThan(0.01 * length);
        assertThat(usual.headingRadians()).isCloseTo(fine.headingRadians(), withPercentage(1));
    }

    private static Pose2 curve(long stepNanos) {
        RobotBench bench = new RobotBench(TestWorlds.with(), TestWorlds.educator(), new Pose2(0, 0, 0),
                new ArenaSettings(false, stepNanos));
        bench.drive(100, 60);
        bench.runMillis(3000);
        bench.drive(0, 0);
        bench.runMillis(1000);
        return bench.robot.pose();
    }

    @Test
    void batterySagsUnderLoadAndRecovers() {
        RobotBench bench = RobotBench.real(TestWorlds.with(), TestWorlds.educator());
        float resting = bench.devices.battery().voltageVolts();
        bench.drive(100, 100);
        bench.runMillis(20);
        float loaded = bench.devices.battery().voltageVolts();
        assertThat(loaded).isLessThan(resting - 0.2f);
        assertThat(bench.devices.battery().motorCurrentAmperes()).isGreaterThan(1.5f);
        bench.drive(0, 0);
        bench.runMillis(1000);
        assertThat(bench.devices.battery().voltageVolts()).isEqualTo(resting);
    }

    @Test
    void batterySagsByATenthToAFifthOfAnOhm() {
        RobotBench bench = RobotBench.real(TestWorlds.with(), TestWorlds.educator());
        assertThat(bench.devices.battery().voltageVolts()).as("typical reading").isCloseTo(8.2f, withPercentage(1));
        float resting = bench.devices.battery().voltageVolts();
        float idle = bench.devices.battery().batteryCurrentAmperes();
        bench.drive(100, 100);
        bench.runMillis(20);
        float drawn = bench.devices.battery().batteryCurrentAmperes() - idle;
        assertThat((resting - bench.devices.battery().voltageVolts()) / drawn).isBetween(0.1f, 0.2f);
    }

    @Test
    void emptierBatteryDrivesSlower() {
        RobotBench full = RobotBench.real(TestWorlds.with(), TestWorlds.educator());
        RobotBench empty = RobotBench.real(TestWorlds.with(), TestWorlds.educator());
        empty.devices.battery().setOpenVolts(6.9);
        full.drive(100, 100);
        empty.drive(100, 100);
        full.runMillis(2000);
        empty.runMillis(2000);
        assertThat(empty.robot.distanceMetres()).isCloseTo(full.robot.distanceMetres() * 6.9 / 8.2, withPercentage(4));
    }
}
