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

    @Override
    public final Figures measure(Effort effort) {
        int steps = effort.nest() ? Math.max(2_000, STEPS_PER_ROUND * 4 / (3 + robots)) : 100;
        long begin = System.nanoTime();
        while (System.nanoTime() - begin < effort.warmUpMillis() * 1_000_000) {
            round(steps);
        }
        Figures[] rounds = new Figures[ROUNDS * effort.rounds()];
        for (int i = 0; i < rounds.length; i++) {
            rounds[i] = round(steps);
        }
        return ProgramSpeed.medians(rounds);
    }

    /** Every round begins anew: after thousands of turns the solver's angles are too coarse for a circle. */
    private Figures round(int steps) {
        Stepper stepper = stepper();
        long cpu = HostReading.ownNanos();
        long bytes = HostReading.ownBytes();
        long now = 0;
        for (int i = 0; i < steps; i++) {
            now += ArenaSettings.DEFAULT_STEP_NANOS;
            stepper.step(now);
        }
        double allocated = HostReading.ownBytes() - bytes;
        return new Figures().put("nanosPerStep", (double) (HostReading.ownNanos() - cpu) / steps)
                .put("bytesPerStep", allocated / steps);
    }
}
