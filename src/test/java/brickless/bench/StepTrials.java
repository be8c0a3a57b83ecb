package brickless.bench;

import brickless.TestWorlds;
import brickless.device.RobotBench;
import brickless.hardware.MoveRequest;
import brickless.hardware.RegulationState;
import brickless.physics.Arena;
import brickless.physics.ArenaSettings;
import brickless.physics.Entrant;
import brickless.physics.RobotBody;
import brickless.world.MotorType;
import brickless.world.Obstacle;
import brickless.world.Point2;
import brickless.world.Pose2;
import brickless.world.RobotModel;
import brickless.world.RobotModel.Claw;
import brickless.world.RobotModel.SensorMount;
import brickless.world.SensorType;
import brickless.world.World;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * What robots do all day, each as a few numbers that a coarse step may get wrong: millimetres, degrees or milliseconds.
 * Every trial has some variants, so that no lucky phase of a step decides.
 */
enum StepTrials {
    /** A regulated metre at 360 deg/s. */
    STRAIGHT("straight metre", "mm", 4) {
        @Override
        double[] run(ArenaSettings settings, int variant) {
            RobotBench bench = robot(settings, 0.1 * variant);
            bench.rotate(METRE, METRE, SPEED);
            return place(bench.robot.pose());
        }
    },
    /** A regulated full turn in place. */
    TURN("turn in place", "°", 4) {
        @Override
        double[] run(ArenaSettings settings, int variant) {
            RobotBench bench = robot(settings, 0.1 * variant);
            bench.rotate(TURN_ROUND, -TURN_ROUND, SPEED);
            return new double[] {bench.headingDegrees()};
        }
    },
    /** Two seconds of unregulated driving in a curve, one second of rolling out. */
    CURVE("open-loop curve", "mm", 4) {
        @Override
        double[] run(ArenaSettings settings, int variant) {
            RobotBench bench = robot(settings, 0.1 * variant);
            bench.drive(100, 60);
            bench.runMillis(2000 + variant);
            bench.drive(0, 0);
            bench.runMillis(1000);
            return place(bench.robot.pose());
        }
    },
    /** A blocked claw: when its motor gives up. */
    STALL("stall found", "ms", 4) {
        @Override
        double[] run(ArenaSettings settings, int variant) {
            RobotBench bench = bench(settings, TestWorlds.with(), clawed(), new Pose2(0, 0, 0));
            bench.runMillis(variant);
            double begin = bench.processor.nowNanos() / NANOS_PER_MILLI;
            bench.devices.motor(0).move(new MoveRequest(SPEED, 6000, 300, true));
            bench.devices.motor(0).awaitStandstill();
            if (bench.devices.motor(0).state() != RegulationState.STALL) {
                throw new IllegalStateException("the claw did not stall");
            }
            return new double[] {bench.processor.nowNanos() / NANOS_PER_MILLI - begin};
        }
    },
    /** Wheels that push a wall: how far the robot has got along it after two seconds. */
    WALL("along an oblique wall", "mm", 4) {
        @Override
        double[] run(ArenaSettings settings, int variant) {
            RobotBench bench = bench(settings, TestWorlds.with(WALL_AHEAD), TestWorlds.educator(),
                    new Pose2(0, 0, 0.9 + 0.1 * variant));
            bench.drive(60, 60);
            bench.runMillis(2000);
            return place(bench.robot.pose());
        }
    },
    /** A crate pushed off its centre for two seconds. */
    PUSH("pushed crate", "mm", 4) {
        @Override
        double[] run(ArenaSettings settings, int variant) {
            Obstacle crate = TestWorlds.crate("crate", 0.2, 0.005 + 0.01 * variant, 0.15, 0.3);
            RobotBench bench = bench(settings, TestWorlds.with(crate), TestWorlds.educator(), new Pose2(0, 0, 0));
            bench.drive(60, 60);
            bench.runMillis(2000);
            return place(bench.arena.obstacles().get(0).displacement());
        }
    },
    /** A row of four touching crates pushed for two seconds. */
    ROW("row of crates", "mm", 4) {
        @Override
        double[] run(ArenaSettings settings, int variant) {
            List<Obstacle> crates = new ArrayList<>();
            for (int i = 0; i < 4; i++) {
                crates.add(TestWorlds.crate("c" + i, 0.12 + 0.1 * i, 0.003 * variant * i, 0.098, 0.15));
            }
            RobotBench bench = bench(settings, TestWorlds.world(crates, List.of()), TestWorlds.educator(),
                    new Pose2(0, 0, 0));
            bench.drive(60, 60);
            bench.runMillis(2000);
            return place(bench.arena.obstacles().get(3).displacement());
        }
    },
    /** Two robots that push each other for two seconds, the second one lighter: where both are. */
    CONTEST("pushing contest", "mm", 4) {
        @Override
        double[] run(ArenaSettings settings, int variant) {
            Arena arena = new Arena(TestWorlds.with(), List.of(new Entrant("heavy", weighing(1.2), new Pose2(0, 0, 0)),
                    new Entrant("light", weighing(0.7), new Pose2(0.2, 0.004 * variant, Math.PI))), settings);
            for (RobotBody robot : arena.robots()) {
                for (int port = 1; port <= 2; port++) {
                    robot.shaft(port).setInertia(1.4e-3);
                    robot.shaft(port).drive(0.2, 0.02, 0.016);
                }
            }
            for (long time = 0; time < 2_000_000_000L; time += settings.stepNanos()) {
                arena.step();
            }
            return new double[] {arena.robots().get(0).xMetres() * MILLIMETRES,
                    arena.robots().get(1).xMetres() * MILLIMETRES};
        }
    },
    /** A robot that weak motors press against a wall: how far it creeps in five seconds. */
    CREEP("creep at a wall", "mm", 1) {
        @Override
        double[] run(ArenaSettings settings, int variant) {
            RobotBench bench = bench(settings, TestWorlds.with(WALL_AHEAD), TestWorlds.educator(),
                    new Pose2(0.2, 0, 0));
            bench.drive(12, 12);
            bench.runMillis(3000);
            double resting = bench.robot.xMetres();
            bench.runMillis(5000);
            return new double[] {(bench.robot.xMetres() - resting) * MILLIMETRES};
        }
    },
    /** The gyro against the heading after ten seconds of zigzag. */
    GYRO("gyro against heading", "°", 4) {
        @Override
        double[] run(ArenaSettings settings, int variant) {
            RobotBench bench = bench(exact(settings), TestWorlds.with(),
                    TestWorlds.educator(sensor(SensorType.EV3_GYRO)), new Pose2(0, 0, 0));
            bench.devices.sensor(0).uart().initialise(0);
            double start = bench.headingDegrees();
            for (int i = 0; i < 20; i++) {
                bench.drive(i % 2 == 0 ? 80 : -30, i % 2 == 0 ? 20 + variant : 90);
                bench.runMillis(500);
            }
            return new double[] {number(bench) - (bench.headingDegrees() - start)};
        }
    },
    /** Where a robot stands that brakes when its ultrasonic sensor reads less than 300 mm. */
    SONAR("ultrasonic stop", "mm", 8) {
        @Override
        double[] run(ArenaSettings settings, int variant) {
            RobotBench bench = bench(exact(settings), TestWorlds.with(TestWorlds.wall("wall", 1, -1, 1.05, 1)),
                    TestWorlds.educator(sensor(SensorType.EV3_ULTRASONIC)), new Pose2(0.003 * variant, 0, 0));
            bench.devices.sensor(0).uart().initialise(0);
            bench.drive(70, 70);
            while (number(bench) > 300) {
                bench.runMillis(1);
            }
            bench.drive(0, 0);
            bench.runMillis(1000);
            return new double[] {bench.robot.xMetres() * MILLIMETRES};
        }
    };

    private static final int METRE = 2046;
    private static final int TURN_ROUND = 733;
    private static final float SPEED = 360;
    private static final double MILLIMETRES = 1000;
    private static final double NANOS_PER_MILLI = 1e6;
    private static final Obstacle WALL_AHEAD = TestWorlds.wall("wall", 0.3, -2, 0.35, 2);

    final String title;
    final String unit;
    final int variants;

    StepTrials(String title, String unit, int variants) {
        this.title = title;
        this.unit = unit;
        this.variants = variants;
    }

    /** Runs one variant; equal settings give equal numbers. */
    abstract double[] run(ArenaSettings settings, int variant);

    private static RobotBench robot(ArenaSettings settings, double heading) {
        return bench(settings, TestWorlds.with(), TestWorlds.educator(), new Pose2(0, 0, heading));
    }

    private static RobotBench bench(ArenaSettings settings, World world, RobotModel model, Pose2 start) {
        return new RobotBench(world, model, start, settings);
    }

    /** Noise would hide what is looked for. */
    private static ArenaSettings exact(ArenaSettings settings) {
        return new ArenaSettings(true, settings.stepNanos(), settings.velocityIterations(),
                settings.positionIterations());
    }

    private static double[] place(Pose2 pose) {
        return new double[] {pose.x() * MILLIMETRES, pose.y() * MILLIMETRES};
    }

    private static int number(RobotBench bench) {
        byte[] bytes = new byte[2];
        bench.devices.sensor(0).uart().read(bytes, 0, 2);
        return (short) (bytes[0] & 0xff | bytes[1] << 8);
    }

    private static SensorMount sensor(SensorType type) {
        return new SensorMount("sensor", 0, type, new Point2(0.06, 0), 0, 0.06, List.of(), Optional.empty());
    }

    private static RobotModel weighing(double kilograms) {
        RobotModel base = TestWorlds.educator();
        return new RobotModel("pusher", base.chassis(), kilograms, base.wheels(), base.casters(), List.of(), List.of(),
                List.of(), "");
    }

    private static RobotModel clawed() {
        Claw claw = new Claw("claw", 0, MotorType.MEDIUM, 0, 90, false, new Point2(0.06, 0),
                List.of(TestWorlds.box(0.05, -0.05, 0.11, -0.04)));
        RobotModel base = TestWorlds.educator();
        return new RobotModel("gripper", base.chassis(), base.massKilograms(), base.wheels(), base.casters(),
                List.of(), List.of(), List.of(claw), "");
    }

    /**
     * A room with four walls and crates, through which a robot with a distance sensor bumps: what a second of it costs
     * is measured.
     */
    static RobotBench room(ArenaSettings settings) {
        List<Obstacle> obstacles = new ArrayList<>(
                List.of(TestWorlds.wall("n", -1, -1, 1, -0.95), TestWorlds.wall("s", -1, 0.95, 1, 1),
                        TestWorlds.wall("w", -1, -1, -0.95, 1), TestWorlds.wall("e", 0.95, -1, 1, 1)));
        for (int i = 0; i < 5; i++) {
            obstacles.add(TestWorlds.crate("c" + i, 0.4 + 0.13 * (i % 4), -0.3 + 0.3 * (i / 4), 0.1, 0.05 + 0.1 * i));
        }
        RobotBench bench = bench(settings, TestWorlds.world(obstacles, List.of()),
                TestWorlds.educator(sensor(SensorType.EV3_ULTRASONIC)), new Pose2(0, 0, 0.1));
        bench.devices.sensor(0).uart().initialise(0);
        return bench;
    }
}
