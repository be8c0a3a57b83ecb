package brickless.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;
import static org.assertj.core.data.Percentage.withPercentage;

import brickless.TestWorlds;
import brickless.physics.Arena;
import brickless.physics.ArenaSettings;
import brickless.physics.Entrant;
import brickless.physics.Shaft;
import brickless.world.Point2;
import brickless.world.Pose2;
import brickless.world.RobotModel;
import brickless.world.RobotModel.Caster;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tyres and casters against the arithmetic of friction, and who pushes whom. */
class TractionTest {
    private static final double GRAVITY = 9.81;
    private static final double TYRE_FRICTION = 0.8;
    private static final double RADIUS = 0.028;

    private static RobotModel model(double kilograms, double drag, double left, double right) {
        RobotModel base = TestWorlds.educator();
        return new RobotModel("pusher", List.of(TestWorlds.box(left, -0.07, right, 0.07)), kilograms, base.wheels(),
                List.of(new Caster("ball", new Point2(-0.09, 0), drag)), List.of(), List.of(), List.of(), "");
    }

    /** Middle of the chassis 30 mm behind the axle, caster 90 mm behind: the wheels carry two thirds. */
    private static RobotModel model(double kilograms, double drag) {
        return model(kilograms, drag, -0.11, 0.05);
    }

    private static double metresUntilRest(RobotBench bench) {
        double start = bench.robot.distanceMetres();
        bench.runMillis(5000);
        return bench.robot.distanceMetres() - start;
    }

    private static RobotBench rolling(RobotModel model) {
        RobotBench bench = RobotBench.real(TestWorlds.with(), model);
        bench.drive(100, 100);
        bench.runMillis(1000);
        return bench;
    }

    private static double speed(RobotBench bench) {
        return bench.robot.shaft(RobotBench.LEFT).speedRadiansPerSecond() * RADIUS;
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.4, 0.8, 1.6})
    void lockedWheelsSlideAsFarAsTheirFrictionSays(double kilograms) {
        RobotBench bench = rolling(model(kilograms, 0.1));
        double speed = speed(bench);
        for (int port : new int[] {RobotBench.LEFT, RobotBench.RIGHT}) {
            Shaft shaft = bench.robot.shaft(port);
            shaft.setStops(shaft.angleRadians(), shaft.angleRadians());
        }
        double deceleration = GRAVITY * (TYRE_FRICTION * 2 / 3 + 0.1 / 3);
        assertThat(metresUntilRest(bench)).isCloseTo(speed * speed / (2 * deceleration), withPercentage(3));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.05, 0.2})
    void robotWithoutMotorsRollsUntilCasterAndHubsHaveStoppedIt(double drag) {
        RobotBench bench = rolling(model(0.8, drag));
        bench.devices.motor(RobotBench.LEFT).plug(null);
        bench.devices.motor(RobotBench.RIGHT).plug(null);
        double speed = speed(bench);
        double force = drag * 0.8 * GRAVITY / 3 + 2 * 1e-3 / RADIUS;
        double mass = 0.8 + 2 * 8e-6 / (RADIUS * RADIUS);
        double metres = speed * speed * mass / (2 * force);
        bench.runMillis(15_000);
        assertThat(metresUntilRest(bench)).as("at rest").isLessThan(1e-6);
        double rolled = bench.robot.xMetres() - distanceWhenPulled(drag);
        assertThat(rolled).isCloseTo(metres, withPercentage(3));
    }

    private static double distanceWhenPulled(double drag) {
        return rolling(model(0.8, drag)).robot.xMetres();
    }

    private static Arena duel(RobotModel first, RobotModel second, Pose2 secondStart, boolean ideal) {
        return new Arena(TestWorlds.with(), List.of(new Entrant("first", first, new Pose2(0, 0, 0)),
                new Entrant("second", second, secondStart)), ArenaSettings.of(ideal));
    }

    private static void push(Arena arena, int robot, double newtonMetres) {
        for (int port = 1; port <= 2; port++) {
            Shaft shaft = arena.robots().get(robot).shaft(port);
            shaft.setInertia(1.4e-3);
            shaft.drive(newtonMetres, 0.02, 0.016);
        }
    }

    private static double pushed(Arena arena, int steps) {
        double before = arena.robots().get(1).xMetres();
        for (int i = 0; i < steps; i++) {
            arena.step();
        }
        return arena.robots().get(1).xMetres() - before;
    }

    private static double contest(RobotModel first, RobotModel second) {
        Arena arena = duel(first, second, new Pose2(0.12, 0, Math.PI), false);
        push(arena, 0, 0.3);
        push(arena, 1, 0.3);
        return pushed(arena, 1500);
    }

    @Test
    void heavierOfTwoRobotsWithEqualMotorsPushesTheOtherBack() {
        assertThat(contest(model(1.1, 0.05), model(0.8, 0.05))).isGreaterThan(0.2);
        assertThat(contest(model(0.8, 0.05), model(1.1, 0.05))).isLessThan(-0.1);
    }

    @Test
    void equalRobotsPushInVain() {
        assertThat(contest(model(0.9, 0.05), model(0.9, 0.05))).isCloseTo(-0.01, offset(0.012));
    }

    @Test
    void equallyHeavyRobotWithMoreWeightOnItsWheelsWins() {
        assertThat(contest(model(0.9, 0.05, -0.05, 0.05), model(0.9, 0.05, -0.13, 0.05))).isGreaterThan(0.2);
    }

    @Test
    void tyresHoldSidewaysUpToTheirFrictionIdealOnesAlways() {
        assertThat(pushedFromTheSide(1.6, false)).as("heavy pusher").isGreaterThan(0.05);
        assertThat(pushedFromTheSide(0.5, false)).as("light pusher").isCloseTo(0, offset(0.003));
        assertThat(pushedFromTheSide(1.6, true)).as("ideal tyres").isCloseTo(0, offset(0.003));
    }

    /** The second robot stands across, its axle in the line of the first one's push. */
    private static double pushedFromTheSide(double kilograms, boolean ideal) {
        Arena arena = duel(model(kilograms, 0.05), model(0.7, 0.05), new Pose2(0.125, 0, Math.PI / 2), ideal);
        push(arena, 0, 0.3);
        push(arena, 1, 0);
        return pushed(arena, 1000);
    }
}
