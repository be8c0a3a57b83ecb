package brickless.simulation;

import brickless.trace.ReportScene;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.function.Predicate;

/**
 * A run in progress: advance it, look at the robots, press keys, and read the outcome.
 *
 * <p>Used by one thread. Between two calls the run stands still at a physics step. If the thread is interrupted while
 * it waits for the run, the run ends and the call throws {@link java.util.concurrent.CancellationException}.
 */
public final class Run implements AutoCloseable {
    private final RunEngine engine;

    Run(RunEngine engine) {
        this.engine = engine;
    }

    /** Lets the simulated time go on by a duration, or until the run ends. */
    public void advance(Duration duration) {
        engine.advanceTo(engine.nowNanos() + duration.toNanos());
    }

    /**
     * Lets the simulated time go on until a condition holds, checked every 10 ms of simulated time.
     *
     * @return whether the condition held within the limit
     */
    public boolean advanceUntil(Predicate<Run> condition, Duration limit) {
        long end = engine.nowNanos() + limit.toNanos();
        while (!condition.test(this)) {
            if (ended() || engine.nowNanos() >= end) {
                return condition.test(this);
            }
            engine.advanceTo(Math.min(end, engine.nowNanos() + 10_000_000));
        }
        return true;
    }

    /** Runs to the end: of the program, or of the time limit. */
    public void toEnd() {
        engine.advanceTo(Long.MAX_VALUE);
    }

    /** Whether the run is over. */
    public boolean ended() {
        return engine.ended();
    }

    /** Simulated time since the start. */
    public Duration time() {
        return Duration.ofNanos(engine.nowNanos());
    }

    /** Length of a physics step: what is done to the run while it is held takes effect with the next one. */
    public Duration step() {
        return Duration.ofNanos(engine.stepNanos());
    }

    /** Where everything is now and what the sensors see: a picture of the present instant, which changes nothing. */
    public Frame frame() {
        return engine.frame();
    }

    /** What to draw the run with. */
    public ReportScene scene() {
        return engine.scene();
    }

    /** The (first) robot. */
    public RobotView robot() {
        return new RobotView(engine.sessions().get(0));
    }

    /** All robots. */
    public List<RobotView> robots() {
        return engine.sessions().stream().map(RobotView::new).toList();
    }

    /** Names of the zones that robots entered so far, in order of first entry. */
    public List<String> zonesEntered() {
        return List.copyOf(engine.journey().zones());
    }

    /** Contacts of robots with obstacles or each other that began so far. */
    public int collisions() {
        return engine.journey().collisions();
    }

    /** Presses a key of the first robot for 200 ms of simulated time, beginning when the run goes on. */
    public void press(String key) {
        Integer mask = StimuliReader.KEYS.get(key.toUpperCase(Locale.ROOT));
        if (mask == null) {
            throw new IllegalArgumentException("no key " + key + "; keys are "
                    + String.join(", ", StimuliReader.KEYS.keySet()));
        }
        engine.add(new Stimulus.Press(engine.nowNanos(), mask, 200_000_000, "press " + key + " 200ms"));
    }

    /** Does something to a robot or the world when the run goes on; times in the past mean now. */
    public void stimulate(Stimulus stimulus) {
        engine.add(stimulus);
    }

    /**
     * How the run ended.
     *
     * @throws IllegalStateException if it has not ended
     */
    public Outcome outcome() {
        return report().outcome();
    }

    /**
     * The figures of the run.
     *
     * @throws IllegalStateException if it has not ended
     */
    public RunReport report() {
        return engine.report();
    }

    /** Ends the run now if it has not ended. */
    @Override
    public void close() {
        engine.stop();
    }
}
