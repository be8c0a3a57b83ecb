package brickless.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import brickless.TestWorlds;
import brickless.physics.Arena;
import brickless.physics.ArenaListener;
import brickless.physics.ArenaSettings;
import brickless.physics.Entrant;
import brickless.physics.RobotBody;
import brickless.physics.Solid;
import brickless.world.Obstacle;
import brickless.world.Pose2;
import brickless.world.Region;
import brickless.world.World;
import brickless.world.Zone;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Robots against walls, crates, zones and edges. */
class PushingTest {
    private static final Obstacle WALL = TestWorlds.wall("wall", 0.3, -1, 0.35, 1);

    /** What an iterative solver may leave when everything comes to rest, joules: about a millimetre per second. */
    private static final double SOLVER_RESIDUAL = 1e-6;

    private static RobotBench pushing(Obstacle obstacle, int duty, long millis) {
        RobotBench bench = RobotBench.real(TestWorlds.with(obstacle), TestWorlds.educator());
        bench.drive(duty, duty);
        bench.runMillis(millis);
        return bench;
    }

    @Test
    void wallStopsTheRobotAndTheWheelsSpinOn() {
        RobotBench bench = pushing(WALL, 60, 2000);
        assertThat(bench.robot.xMetres()).isCloseTo(0.25, offset(0.004));
        int tacho = bench.devices.motor(RobotBench.LEFT).encoder();
        bench.runMillis(1000);
        assertThat(bench.devices.motor(RobotBench.LEFT).encoder()).isGreaterThan(tacho + 100);
        assertThat(bench.robot.xMetres()).isCloseTo(0.25, offset(0.004));
    }

    @Test
    void weakMotorsStandStillAgainstTheWallWithoutCreeping() {
        RobotBench bench = RobotBench.real(TestWorlds.with(WALL), TestWorlds.educator());
        bench.arena.move(bench.robot, new Pose2(0.2, 0, 0));
        bench.drive(12, 12);
        bench.runMillis(3000);
        Pose2 pose = bench.robot.pose();
        int tacho = bench.devices.motor(RobotBench.LEFT).encoder();
        bench.runMillis(10_000);
        assertThat(bench.robot.xMetres()).isCloseTo(pose.x(), offset(1e-5));
        assertThat(bench.devices.motor(RobotBench.LEFT).encoder()).isEqualTo(tacho);
    }

    @Test
    void heavyCrateDoesNotCreep() {
        RobotBench bench = pushing(TestWorlds.crate("crate", 0.3, 0, 0.2, 20), 60, 5000);
        assertThat(bench.arena.obstacles().get(0).displacement().x()).isCloseTo(0, offset(5e-4));
    }

    @Test
    void lighterCratesAreSlowedLess() {
        double none = pushing(TestWorlds.crate("crate", 0.3, 1, 0.2, 0.1), 60, 1500).robot.xMetres();
        double light = pushing(TestWorlds.crate("crate", 0.3, 0, 0.2, 0.1), 60, 1500).robot.xMetres();
        double heavy = pushing(TestWorlds.crate("crate", 0.3, 0, 0.2, 0.6), 60, 1500).robot.xMetres();
        assertThat(light).isLessThan(none);
        assertThat(heavy).isLessThan(light);
        assertThat(heavy).isGreaterThan(0.3);
    }

    @Test
    void crateStopsWhenItIsNoLongerPushed() {
        RobotBench bench = pushing(TestWorlds.crate("crate", 0.3, 0, 0.2, 0.2), 60, 1500);
        bench.drive(-60, -60);
        bench.runMillis(1000);
        Pose2 rest = bench.arena.obstacles().get(0).displacement();
        bench.runMillis(5000);
        assertThat(bench.arena.obstacles().get(0).displacement()).isEqualTo(rest);
        assertThat(bench.arena.obstacles().get(0).displaced()).isTrue();
    }

    /** A coasting robot (no energy comes in) runs into crates and walls at many angles: kinetic energy never grows. */
    @Test
    void collisionsNeverAddEnergy() {
        for (int index = 0; index < 24; index++) {
            Obstacle obstacle = index % 2 == 0 ? WALL
                    : TestWorlds.crate("crate", 0.3, 0.02 * (index / 2 - 6), 0.15, 0.3);
            RobotBench bench = new RobotBench(TestWorlds.with(obstacle), TestWorlds.educator(),
                    new Pose2(-0.1, 0, 0.06 * (index - 12)),
                    ArenaSettings.of(false));
            bench.drive(100, 100);
            bench.runMillis(350);
            bench.devices.motor(RobotBench.LEFT).coast();
            bench.devices.motor(RobotBench.RIGHT).coast();
            double energy = energy(bench);
            for (int step = 0; step < 500; step++) {
                bench.runMillis(2);
                double now = energy(bench);
                assertThat(now).as("index %d step %d", index, step)
                        .isLessThanOrEqualTo(energy * (1 + 1e-6) + SOLVER_RESIDUAL);
                energy = now;
            }
        }
    }

    private static double energy(RobotBench bench) {
        double sum = bench.robot.kineticEnergyJoules() + bench.arena.obstacles().get(0).kineticEnergyJoules();
        for (int port = 1; port <= 2; port++) {
            double speed = bench.robot.shaft(port).speedRadiansPerSecond();
            sum += bench.robot.shaft(port).inertia() * speed * speed / 2;
        }
        return sum;
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.2, 0.5, 0.8, 1.1})
    void obliqueWallIsFollowedNotEntered(double heading) {
        RobotBench bench = new RobotBench(TestWorlds.with(WALL), TestWorlds.educator(), new Pose2(0, 0, heading),
                ArenaSettings.of(false));
        bench.drive(70, 70);
        for (int i = 0; i < 300; i++) {
            bench.runMillis(10);
            assertThat(rightmost(bench.robot.pose())).isLessThan(0.302);
        }
    }

    private static double rightmost(Pose2 pose) {
        double most = Double.NEGATIVE_INFINITY;
        for (double[] corner : new double[][] {{-0.11, -0.07}, {-0.11, 0.07}, {0.05, -0.07}, {0.05, 0.07}}) {
            most = Math.max(most, pose.x() + corner[0] * Math.cos(pose.headingRadians()) - corner[1]
                    * Math.sin(pose.headingRadians()));
        }
        return most;
    }

    @Test
    void collisionIsToldOnceWithTheHitterFirst() {
        List<String> told = new ArrayList<>();
        RobotBench bench = RobotBench.real(TestWorlds.with(WALL), TestWorlds.educator());
        bench.arena.setListener(new ArenaListener() {
            @Override
            public void collision(Solid hitter, Solid hit, double speed) {
                told.add(hitter.name() + ">" + hit.name());
                assertThat(speed).isBetween(0.1, 0.5);
            }
        });
        bench.drive(60, 60);
        bench.runMillis(3000);
        assertThat(told).containsExactly("robot>wall");
    }

    @Test
    void zonesAndFallsAreTold() {
        List<String> told = new ArrayList<>();
        Region goal = new Region.Filled(List.of(TestWorlds.box(0.1, -0.2, 0.2, 0.2)), false);
        Region table = new Region.Filled(List.of(TestWorlds.box(-0.5, -0.5, 0.5, 0.5)), false);
        World world = new World("table", -1, -1, 2, 2, List.of(), List.of(), List.of(new Zone("goal", goal)),
                List.of(), List.of(),
                Optional.of(table), List.of(), "");
        RobotBench bench = RobotBench.real(world, TestWorlds.educator());
        bench.arena.setListener(new ArenaListener() {
            @Override
            public void zoneEntered(RobotBody robot, String zone) {
                told.add("in " + zone);
            }

            @Override
            public void zoneLeft(RobotBody robot, String zone) {
                told.add("out " + zone);
            }

            @Override
            public void fell(RobotBody robot) {
                told.add("fell at " + Math.round(robot.xMetres() * 100));
            }
        });
        bench.drive(60, 60);
        bench.runMillis(4000);
        assertThat(told).containsExactly("in goal", "out goal", "fell at 50");
        assertThat(bench.robot.fallen()).isTrue();
    }

    @Test
    void removedObstaclesAreGoneAndMovedRobotsStandStill() {
        RobotBench bench = pushing(WALL, 60, 2000);
        bench.arena.remove(bench.arena.obstacle("wall").orElseThrow());
        assertThat(bench.arena.obstacle("wall")).isEmpty();
        bench.runMillis(1000);
        assertThat(bench.robot.xMetres()).isGreaterThan(0.4);
        bench.drive(0, 0);
        bench.runMillis(1000);
        bench.arena.move(bench.robot, new Pose2(-1, 0.5, Math.PI / 2));
        bench.runMillis(100);
        assertThat(bench.robot.xMetres()).isCloseTo(-1, offset(1e-4));
        assertThat(bench.headingDegrees()).isCloseTo(90, offset(0.1));
    }

    @Test
    void twoRobotsPushEachOther() {
        Arena arena = new Arena(TestWorlds.with(), List.of(
                new Entrant("a", TestWorlds.educator(), new Pose2(0, 0, 0)),
                new Entrant("b", TestWorlds.educator(), new Pose2(0.4, 0, Math.PI))),
                        ArenaSettings.of(false));
        for (int port = 1; port <= 2; port++) {
            arena.robots().get(0).shaft(port).setInertia(1.4e-3);
            arena.robots().get(0).shaft(port).drive(0.3, 0.02, 0.016);
            arena.robots().get(1).shaft(port).setInertia(1.4e-3);
            arena.robots().get(1).shaft(port).drive(0, 0.02, 0.016);
        }
        for (int i = 0; i < 1000; i++) {
            arena.step();
        }
        assertThat(arena.robots().get(1).xMetres()).isGreaterThan(0.45);
        assertThat(arena.robots().get(1).xMetres() - arena.robots().get(0).xMetres()).isCloseTo(0.1, offset(0.004));
    }
}
