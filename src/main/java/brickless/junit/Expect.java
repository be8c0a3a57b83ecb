package brickless.junit;

import brickless.simulation.Run;
import java.time.Duration;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;

/**
 * Expectations about how a run goes on. Each lets the simulated time pass until it is decided.
 *
 * <pre>
 * Expect.that(run).within(Duration.ofSeconds(30))
 *         .eventually("enters the goal", r -&gt; r.zonesEntered().contains("goal"));
 * Expect.that(run).within(Duration.ofSeconds(10)).value("x in metres", r -&gt; r.robot().xMetres())
 *         .always("stay below 1.5", x -&gt; x &lt; 1.5);
 * </pre>
 *
 * <p>Conditions are looked at now and then every 10 ms of simulated time. Without {@link #within} they have until the
 * run's time limit. A run that ends early decides too: nothing changes after the end. Failures are
 * {@link org.opentest4j.AssertionFailedError}s that name the simulated time. Used by the thread that uses the run.
 */
public final class Expect {
    private final Run run;
    private final Optional<Duration> time;

    private Expect(Run run, Optional<Duration> time) {
        this.run = run;
        this.time = time;
    }

    /** Expectations about a run. */
    public static Expect that(Run run) {
        return new Expect(run, Optional.empty());
    }

    /** The simulated time, from now on, that the next expectation is about. */
    public Expect within(Duration duration) {
        if (duration.isNegative()) {
            throw new IllegalArgumentException("a negative time: " + duration);
        }
        return new Expect(run, Optional.of(duration));
    }

    /**
     * Expectations about a value that is read from the run again and again.
     *
     * @param name what it is, with its unit, for messages
     */
    public <T> ValueExpectation<T> value(String name, Function<Run, T> reading) {
        return new ValueExpectation<>(new Course<>(run, time, name, reading));
    }

    /** Lets time pass until the condition holds; fails if it does not in time. */
    public void eventually(String condition, Predicate<Run> holds) {
        truth(holds).eventually(condition, value -> value);
    }

    /** Lets the time pass; fails as soon as the condition does not hold. */
    public void always(String condition, Predicate<Run> holds) {
        truth(holds).always(condition, value -> value);
    }

    /** Lets the time pass; fails as soon as the condition holds. */
    public void never(String condition, Predicate<Run> holds) {
        truth(holds).never(condition, value -> value);
    }

    private ValueExpectation<Boolean> truth(Predicate<Run> holds) {
        return new ValueExpectation<>(new Course<>(run, time, "", holds::test));
    }
}
