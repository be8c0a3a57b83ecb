package brickless.bench;

import brickless.device.FakeProcessor;
import brickless.device.RobotDevices;
import brickless.kernel.Kernel;
import brickless.kernel.KernelSettings;
import brickless.loading.LoadingRules;
import brickless.loading.RobotClassLoader;
import brickless.physics.Arena;
import brickless.physics.ArenaSettings;
import brickless.world.Point2;
import brickless.world.Pose2;
import brickless.world.RobotModel.SensorMount;
import brickless.world.SensorType;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/** The pieces in which a run spends its time, one by one. */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
public class HotPieces {
    private static final int SWITCHES = 100_000;

    /** A robot in the middle of its room, with all that is measured here plugged in. */
    @State(Scope.Thread)
    public static class Robot {
        private static final long STEP_NANOS = ArenaSettings.DEFAULT_STEP_NANOS;
        private final Arena arena = new Arena(new RobotGrid(1).world(), new RobotGrid(1).entrants(),
                ArenaSettings.of(false));
        private final RobotDevices devices = RobotDevices.of(arena, arena.robots().get(0),
                new FakeProcessor(STEP_NANOS, time -> { }), 1, false);
        private final byte[] message = new byte[2];
        private long now;
        private int place;

        /** Both motors run, all sensors are on. */
        public Robot() {
            devices.sensor(2).plug(new SensorMount("colour", 2, SensorType.EV3_COLOR, new Point2(0.05, 0), 0, 0.008,
                    List.of(), Optional.empty()));
            devices.sensor(2).uart().initialise(0);
            devices.sensor(3).uart().initialise(0);
            devices.motor(1).drive(40);
            devices.motor(2).drive(25);
        }
    }

    /** Controllers and motors of a robot with two motors, for one physics step. */
    @Benchmark
    public void motorStep(Robot robot) {
        robot.devices.beforeStep(robot.now += Robot.STEP_NANOS);
    }

    /** The solver's step of a moving robot. */
    @Benchmark
    public void arenaStep(Robot robot) {
        robot.devices.motor(1).beforeStep(0, 8);
        robot.devices.motor(2).beforeStep(0, 8);
        robot.arena.step();
    }

    /** A ping of the ultrasonic sensor: nine rays. */
    @Benchmark
    public int rayFan(Robot robot) {
        robot.devices.sensor(3).afterStep(robot.now += 25_000_000);
        return robot.message[0];
    }

    /** A reading of the colour sensor at a place it has not looked at before. */
    @Benchmark
    public int colourSpot(Robot robot) {
        robot.place = (robot.place + 1) % 500;
        robot.arena.move(robot.arena.robots().get(0), new Pose2(0.5 + robot.place * 0.001, 0.75, 0));
        return robot.devices.sensor(2).uart().read(robot.message, 0, 1);
    }

    /** A kernel with a program that has not begun. */
    @State(Scope.Thread)
    public static class Program {
        private Kernel kernel;
        private RobotClassLoader loader;

        /** A new one for every invocation: a kernel runs once. */
        @Setup(Level.Invocation)
        public void load() throws Exception {
            loader = RobotClassLoader.ofApplication(HotPieces.class.getClassLoader(),
                    LoadingRules.standard().rewriting(Loops.class.getName()));
            kernel = new Kernel(KernelSettings.defaults());
            kernel.bind(loader.bind(kernel));
            loader.loadClass(Loops.class.getName());
        }

        private void run(Runnable body) {
            Thread main = loader.programThread("main", body);
            kernel.run(main, main);
        }
    }

    /** Two threads that yield to each other. */
    @Benchmark
    @OperationsPerInvocation(SWITCHES)
    public long contextSwitch(Program program) {
        Runnable half = () -> {
            for (int i = 0; i < SWITCHES / 2; i++) {
                program.kernel.yieldProcessor();
            }
        };
        program.run(() -> {
            program.kernel.start(program.loader.programThread("other", half));
            half.run();
        });
        return program.kernel.contextSwitches();
    }

    /** A turn of a rewritten loop: an addition, a multiplication and the charge. */
    @Benchmark
    @OperationsPerInvocation(Loops.TURNS)
    public long tick(Program program) {
        program.run(() -> {
            try {
                MethodHandles.publicLookup().findStatic(program.loader.loadClass(Loops.class.getName()), "turns",
                        MethodType.methodType(double.class)).invoke();
            } catch (Throwable e) {
                throw new IllegalStateException(e);
            }
        });
        return program.kernel.nowNanos();
    }
}
