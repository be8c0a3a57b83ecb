package brickless.physics;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.TestWorlds;
import brickless.world.MotorType;
import brickless.world.Obstacle;
import brickless.world.Point2;
import brickless.world.Pose2;
import brickless.world.RobotModel;
import brickless.world.RobotModel.SensorMount;
import brickless.world.SensorType;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.pooling.normal.DefaultWorldPool;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The shorter way through a step leads to the same place, bit for bit, as JBox2D's own. */
class LeanWorldTest {
    private static final double STEP_SECONDS = 0.002;
    private static final int STEPS = 6_000;

    /** Three robots and some crates in a small pen, driven by torques that change at random. */
    private static final class Scene {
        private final World world;
        private final List<RobotBody> robots = new ArrayList<>();
        private final List<ObstacleBody> obstacles = new ArrayList<>();
        private final Random random;

        Scene(World world, long seed) {
            Decimetres.use();
            this.world = world;
            this.random = new Random(seed);
            world.setContinuousPhysics(false);
            Body ground = world.createBody(new BodyDef());
            List<Obstacle> drawn = new ArrayList<>(
                    List.of(TestWorlds.wall("north", 0, -0.1, 1.2, 0), TestWorlds.wall("south", 0, 1.2, 1.2, 1.3),
                            TestWorlds.wall("west", -0.1, 0, 0, 1.2), TestWorlds.wall("east", 1.2, 0, 1.3, 1.2)));
            for (int i = 0; i < 5; i++) {
                drawn.add(TestWorlds.crate("crate" + i, 0.15 + 0.22 * i, 0.62, 0.08, 0.1 + 0.2 * i));
            }
            drawn.forEach(obstacle -> obstacles.add(new ObstacleBody(world, ground, obstacle)));
            for (int i = 0; i < 3; i++) {
                Entrant entrant = new Entrant("robot" + i, model(i == 0),
                        new Pose2(0.25 + 0.35 * i, i == 1 ? 0.9 : 0.3, i));
                robots.add(new RobotBody(world, ground, entrant, i, false, drawn.size()));
            }
            world.setContactListener(new Contacts(robots.size()));
        }

        private static RobotModel model(boolean turret) {
            RobotModel plain = TestWorlds.educator(new SensorMount("bumper", 0, SensorType.EV3_TOUCH,
                    new Point2(0.05, 0), 0, 0.03, List.of(), Optional.empty()));
            return new RobotModel(plain.name(), plain.chassis(), plain.massKilograms(), plain.wheels(), plain.casters(),
                    plain.sensors(), !turret ? List.of()
                    : List.of(new RobotModel.Turret("turret", 0, MotorType.MEDIUM, 1, false, new Point2(-0.05, 0),
                            List.of(TestWorlds.box(-0.06, -0.02, 0.0, 0.02)))), List.of(), "");
        }

        void step(int number) {
            for (RobotBody robot : robots) {
                if (number % 150 == 0) {
                    for (int port = 0; port < 3; port++) {
                        robot.shaft(port).drive(0.5 * (random.nextDouble() - 0.4), 0.02, 0.01);
                    }
                }
                if (number == 1_000) {
                    robot.bumper(robot.model().sensors().get(0));
                }
                robot.prepare(STEP_SECONDS);
            }
            if (number == 3_000) {
                robots.get(0).place(new Pose2(0.5, 0.4, 1));
                obstacles.get(5).place(new Pose2(0.9, 0.2, 0.3));
            }
            if (number == 4_000) {
                obstacles.get(6).remove();
            }
            world.step((float) STEP_SECONDS, 6, 2);
            robots.forEach(robot -> robot.finish(STEP_SECONDS));
        }

        /**
         * All there is to know of the bodies; the number of contacts tells whether the boxes of the broad phase are the
         * same.
         */
        List<Object> state() {
            List<Object> state = new ArrayList<>();
            for (Body body = world.getBodyList(); body != null; body = body.m_next) {
                state.add(List.of(body.m_xf.p.x, body.m_xf.p.y, body.m_sweep.a, body.m_linearVelocity.x,
                        body.m_linearVelocity.y, body.m_angularVelocity, body.isAwake(), body.m_sleepTime));
            }
            state.add(world.getContactCount());
            return state;
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void aStepGivesTheSameBitsAsJBox2Ds(long seed) {
        Scene lean = new Scene(new LeanWorld(), seed);
        Scene full = new Scene(new World(new Vec2(0, 0), new DefaultWorldPool(100, 10), new LazyTree()), seed);
        int touching = 0;
        for (int i = 0; i < STEPS; i++) {
            lean.step(i);
            full.step(i);
            if (i % 10 == 0) {
                assertThat(lean.state()).as("after step %d", i).isEqualTo(full.state());
            }
            touching += full.world.getContactCount();
        }
        assertThat(touching).as("robots met things").isGreaterThan(STEPS / 10);
        assertThat(lean.robots.get(1).distanceMetres()).isGreaterThan(0.2);
    }
}
