package brickless.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import brickless.TestWorlds;
import brickless.hardware.MoveRequest;
import brickless.physics.ArenaSettings;
import brickless.world.MotorType;
import brickless.world.Point2;
import brickless.world.Pose2;
import brickless.world.RobotModel;
import brickless.world.RobotModel.Turret;
import brickless.world.RobotModel.Wheel;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Play of gears between a motor and what it turns. */
class BacklashTest {
    private static final int PORT_A = 0;
    private static final double TEN_DEGREES = Math.toRadians(10);
    private static final double MILLIMETRES_PER_DEGREE = Math.PI * 56 / 360;
    private static final float SLOWLY = 30;

    private static RobotModel wheeled(double backlashRadians) {
        return TestWorlds.robot(List.of(wheel("left", 1, -0.057, backlashRadians),
                wheel("right", 2, 0.057, backlashRadians)), List.of());
    }

    private static Wheel wheel(String id, int port, double y, double backlashRadians) {
        return new Wheel(id, port, MotorType.LARGE, 0.056, 1, false, new Point2(0, y), 0, false, backlashRadians);
    }

    private static double millimetres(RobotBench bench) {
        return bench.robot.xMetres() * 1000;
    }

    @Test
    void reversedWheelsFirstCrossThePlay() {
        RobotBench bench = RobotBench.real(TestWorlds.with(), wheeled(TEN_DEGREES));
        bench.rotate(100, 100, SLOWLY);
        double turningBack = millimetres(bench);
        bench.rotate(-8, -8, SLOWLY);
        assertThat(millimetres(bench)).as("within the play").isCloseTo(turningBack, offset(0.5));
        bench.rotate(-32, -32, SLOWLY);
        assertThat(turningBack - millimetres(bench)).as("40 degrees less 10 of play, and a little rolling on")
                .isCloseTo(30 * MILLIMETRES_PER_DEGREE, offset(1.5));
    }

    @Test
    void metreThereAndBackIsOffByNoMoreThanThePlay() {
        RobotBench tight = RobotBench.real(TestWorlds.with(), wheeled(0));
        RobotBench loose = RobotBench.real(TestWorlds.with(), wheeled(TEN_DEGREES));
        for (RobotBench bench : List.of(tight, loose)) {
            bench.rotate(2046, 2046, 360);
            bench.rotate(-2046, -2046, 360);
        }
        assertThat(Math.abs(millimetres(loose) - millimetres(tight))).isBetween(0.5, 10 * MILLIMETRES_PER_DEGREE);
    }

    @Test
    void openLoopDriveIsHardlySlower() {
        RobotBench tight = RobotBench.real(TestWorlds.with(), wheeled(0));
        RobotBench loose = RobotBench.real(TestWorlds.with(), wheeled(TEN_DEGREES));
        for (RobotBench bench : List.of(tight, loose)) {
            bench.drive(70, 50);
            bench.runMillis(2000);
        }
        assertThat(loose.robot.distanceMetres()).isCloseTo(tight.robot.distanceMetres(), offset(0.006));
        assertThat(loose.headingDegrees()).isCloseTo(tight.headingDegrees(), offset(2.0));
    }

    @Test
    void idealGearsHaveNoPlay() {
        RobotBench tight = RobotBench.ideal(TestWorlds.with(), wheeled(0));
        RobotBench loose = RobotBench.ideal(TestWorlds.with(), wheeled(TEN_DEGREES));
        for (RobotBench bench : List.of(tight, loose)) {
            bench.rotate(300, 200, 360);
            bench.rotate(-200, -300, 360);
        }
        assertThat(loose.robot.pose()).isEqualTo(tight.robot.pose());
    }

    @Test
    void parkedRobotComesToRestWithinThePlay() {
        RobotBench bench = RobotBench.real(TestWorlds.with(), wheeled(TEN_DEGREES));
        bench.drive(60, 40);
        bench.runMillis(1000);
        bench.drive(0, 0);
        bench.runMillis(2000);
        Pose2 parked = bench.robot.pose();
        bench.runMillis(5000);
        assertThat(bench.robot.pose()).isEqualTo(parked);
    }

    private static RobotBench turret(double backlashDegrees, boolean outlined, boolean ideal) {
        List<List<Point2>> outlines = outlined ? List.of(TestWorlds.box(0, -0.02, 0.08, 0.02)) : List.of();
        Turret turret = new Turret("head", PORT_A, MotorType.MEDIUM, 1, false, new Point2(0.02, 0), outlines,
                Math.toRadians(backlashDegrees));
        RobotModel base = TestWorlds.educator();
        RobotModel model = new RobotModel("scanner", base.chassis(), base.massKilograms(), base.wheels(),
                base.casters(), List.of(), List.of(turret), List.of(), "");
        return new RobotBench(TestWorlds.with(), model, new Pose2(0, 0, 0), ArenaSettings.of(ideal));
    }

    private static double turretDegrees(RobotBench bench) {
        return Math.toDegrees(bench.robot.turretAngleRadians(0));
    }

    private static void turnTo(RobotBench bench, int degrees) {
        bench.devices.motor(PORT_A).move(new MoveRequest(SLOWLY, 1000, degrees, true));
        bench.devices.motor(PORT_A).awaitStandstill();
        bench.runMillis(500);
    }

    @Test
    void turretLagsHalfThePlayBehindItsMotorOnEitherSide() {
        RobotBench bench = turret(6, false, false);
        turnTo(bench, 90);
        assertThat(turretDegrees(bench)).isCloseTo(-87, offset(1.0));
        turnTo(bench, 50);
        assertThat(turretDegrees(bench)).isCloseTo(-53, offset(1.0));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.5, 3, 12})
    void turretWithMassNeverLeavesThePlay(double backlashDegrees) {
        RobotBench bench = turret(backlashDegrees, true, false);
        double most = 0;
        double least = 0;
        for (int i = 0; i < 400; i++) {
            bench.devices.motor(PORT_A).drive(i / 40 % 2 == 0 ? 60 : -60);
            bench.runMillis(10);
            double ahead = turretDegrees(bench) + Math.toDegrees(bench.robot.shaft(PORT_A).angleRadians());
            most = Math.max(most, ahead);
            least = Math.min(least, ahead);
        }
        assertThat(most).isCloseTo(backlashDegrees / 2, offset(0.4));
        assertThat(least).isCloseTo(-backlashDegrees / 2, offset(0.4));
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void idealTurretHasNoPlay(boolean outlined) {
        RobotBench tight = turret(0, outlined, true);
        RobotBench loose = turret(6, outlined, true);
        turnTo(tight, 70);
        turnTo(loose, 70);
        assertThat(turretDegrees(loose)).isEqualTo(turretDegrees(tight));
    }
}
