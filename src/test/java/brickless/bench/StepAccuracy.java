package brickless.bench;

import brickless.device.RobotBench;
import brickless.physics.ArenaSettings;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * What the physics step and the solver's iterations cost and what they get wrong: the tables of MODELS.md. Errors are
 * the largest of a trial's variants against a reference with steps of 0.25 ms and many iterations; times are processor
 * time of the one thread.
 *
 * <p>{@code StepAccuracy} prints all; {@code StepAccuracy 2.0 6 2} one row.
 */
public final class StepAccuracy {
    private static final ArenaSettings REFERENCE = settings(0.25, 40, 10);
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
    private static final int SECONDS = 20;
    private static final int ROUNDS = 5;

    private StepAccuracy() {}

    /** Runs the benchmark. */
    public static void main(String[] args) {
        List<ArenaSettings> rows = new ArrayList<>();
        if (args.length == 3) {
            rows.add(settings(Double.parseDouble(args[0]), Integer.parseInt(args[1]), Integer.parseInt(args[2])));
        } else {
            for (double millis : new double[] {0.5, 1, 2, 4, 5, 10}) {
                rows.add(settings(millis, ArenaSettings.DEFAULT_VELOCITY_ITERATIONS,
                        ArenaSettings.DEFAULT_POSITION_ITERATIONS));
            }
            for (double millis : new double[] {2, 4}) {
                for (int[] iterations : new int[][] {{1, 1}, {2, 1}, {4, 1}, {10, 4}, {30, 8}}) {
                    rows.add(settings(millis, iterations[0], iterations[1]));
                }
            }
        }
        System.out.println("JDK " + Runtime.version());
        System.out.print("step, iterations");
        for (StepTrials trial : StepTrials.values()) {
            System.out.print(" | " + trial.title + ", " + trial.unit);
        }
        System.out.println(" | CPU per simulated second | x real time");
        rows.forEach(StepAccuracy::row);
    }

    private static ArenaSettings settings(double millis, int velocityIterations, int positionIterations) {
        return new ArenaSettings(false, Math.round(millis * 1e6), velocityIterations, positionIterations);
    }

    private static void row(ArenaSettings settings) {
        StringBuilder line = new StringBuilder(String.format(Locale.ROOT, "%.2f ms, %d/%d", settings.stepNanos() / 1e6,
                settings.velocityIterations(), settings.positionIterations()));
        for (StepTrials trial : StepTrials.values()) {
            line.append(String.format(Locale.ROOT, " | %.2f", error(trial, settings)));
        }
        double cpuSeconds = cpuSecondsPerSimulatedSecond(settings);
        System.out.println(
                line.append(String.format(Locale.ROOT, " | %.2f ms | %.0f", cpuSeconds * 1e3, 1 / cpuSeconds)));
    }

    /** The largest distance to the reference; creep and gyro are errors by themselves. */
    static double error(StepTrials trial, ArenaSettings settings) {
        double largest = 0;
        for (int variant = 0; variant < trial.variants; variant++) {
            double[] coarse = trial.run(settings, variant);
            double[] fine = trial == StepTrials.CREEP || trial == StepTrials.GYRO
                    ? new double[1] : trial.run(REFERENCE, variant);
            double squares = 0;
            for (int i = 0; i < coarse.length; i++) {
                squares += (coarse[i] - fine[i]) * (coarse[i] - fine[i]);
            }
            largest = Math.max(largest, Math.sqrt(squares));
        }
        return largest;
    }

    private static double cpuSecondsPerSimulatedSecond(ArenaSettings settings) {
        long best = Long.MAX_VALUE;
        for (int round = 0; round < ROUNDS; round++) {
            RobotBench bench = StepTrials.room(settings);
            long begin = THREADS.getCurrentThreadCpuTime();
            for (int i = 0; i < SECONDS * 10; i++) {
                int turn = i / 20 % 5;
                bench.drive(turn == 4 ? -60 : 70, turn == 4 ? -20 : 70 - 9 * turn);
                bench.runMillis(100);
            }
            best = Math.min(best, THREADS.getCurrentThreadCpuTime() - begin);
        }
        return best / 1e9 / SECONDS;
    }
}
