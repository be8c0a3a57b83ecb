package brickless.bench;

import brickless.physics.ArenaSettings;

/** Processor time and memory that one step of something takes, in the thread that does it. */
abstract class StepCost implements Measurement {
    private static final int STEPS_PER_ROUND = 50_000;
    private static final int ROUNDS = 5;

    private final int robots;

    StepCost(int robots) {
        this.robots = robots;
    }

    final int robots() {
        return robots;
    }

    /** Builds what is stepped, and returns how to do a step that ends at a time in nanoseconds. */
    abstract Stepper stepper();

    /** Does one step. */
    interface Stepper {
        void step(long timeNanos);
    }

    @Override public final Figures measure(Effort effort) {
        Stepper stepper = stepper();
        int steps = effort.nest() ? Math.max(2_000, STEPS_PER_ROUND * 4 / (3 + robots)) : 100;
        long time = 0;
        long begin = System.nanoTime();
        while (System.nanoTime() - begin < effort.warmUpMillis() * 1_000_000) {
            time = run(stepper, time, steps);
        }
        Figures[] rounds = new Figures[ROUNDS * effort.rounds()];
        for (int i = 0; i < rounds.length; i++) {
            long cpu = HostReading.ownNanos();
            long bytes = HostReading.ownBytes();
            time = run(stepper, time, steps);
            double allocated = HostReading.ownBytes() - bytes;
            rounds[i] = new Figures().put("nanosPerStep", (double) (HostReading.ownNanos() - cpu) / steps)
                    .put("bytesPerStep", allocated / steps);
        }
        return ProgramSpeed.medians(rounds);
    }

    private static long run(Stepper stepper, long time, int steps) {
        long now = time;
        for (int i = 0; i < steps; i++) {
            now += ArenaSettings.DEFAULT_STEP_NANOS;
            stepper.step(now);
        }
        return now;
    }
}
