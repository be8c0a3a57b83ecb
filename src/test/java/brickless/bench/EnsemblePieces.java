package brickless.bench;

import brickless.kernel.Costs;
import brickless.kernel.CountingBudget;
import brickless.kernel.Ensemble;
import brickless.kernel.Kernel;
import brickless.kernel.KernelSettings;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/** What the kernels of a hundred robots take for a step of one robot, without any physics and devices. */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
public class EnsemblePieces {
    private static final int ROBOTS = 100;
    private static final int STEPS = 500;
    private static final long PAUSE_NANOS = 10_000_000;

    /** The kernels of robots whose programs have not begun. */
    @State(Scope.Thread)
    public static class Robots {
        private static final long LIMIT_NANOS = STEPS * KernelSettings.defaults().stepNanos();
        private List<Kernel> kernels;

        /** New ones for every invocation: a kernel runs once. */
        @Setup(Level.Invocation)
        public void create() {
            KernelSettings settings = KernelSettings.defaults().withLimitNanos(LIMIT_NANOS);
            kernels = IntStream.range(0, ROBOTS).mapToObj(i -> new Kernel(settings)).toList();
        }

        private void run(Program program) {
            for (Kernel kernel : kernels) {
                kernel.bind(new CountingBudget());
                Runnable body = () -> program.run(kernel);
                kernel.main(new Thread(body, "main"), body);
            }
            new Ensemble(kernels, time -> { }).run();
        }
    }

    /** A program as rewriting would have produced it. */
    interface Program {
        /** Runs until its kernel ends it. */
        void run(Kernel kernel);
    }

    /** Each robot's only thread sleeps for five steps again and again. */
    @Benchmark
    @OperationsPerInvocation(ROBOTS * STEPS)
    public void sleepingRobot(Robots robots) {
        robots.run(EnsemblePieces::sleep);
    }

    /** Each robot has a thread that yields and one that reads two sensors before: five switches in three steps. */
    @Benchmark
    @OperationsPerInvocation(ROBOTS * STEPS)
    public void pollingRobot(Robots robots) {
        robots.run(EnsemblePieces::poll);
    }

    private static void sleep(Kernel kernel) {
        try {
            while (!kernel.killing()) {
                kernel.sleep(PAUSE_NANOS);
            }
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    private static void poll(Kernel kernel) {
        kernel.start(new Thread(() -> read(kernel), "reader"));
        while (!kernel.killing()) {
            kernel.yieldProcessor();
        }
    }

    private static void read(Kernel kernel) {
        while (!kernel.killing()) {
            kernel.charge(Costs.SENSOR_READ_NANOS);
            kernel.charge(Costs.SENSOR_READ_NANOS);
            kernel.yieldProcessor();
        }
    }
}
