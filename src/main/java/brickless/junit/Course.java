package brickless.junit;

import brickless.simulation.Run;
import java.time.Duration;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import org.opentest4j.AssertionFailedError;

/** The course of a value while simulated time passes, and how to tell it. */
final class Course<T> {
    /** An instant and the value then. */
    private record Moment<T>(Duration time, T value) {
        @Override
        public String toString() {
            return value + " at " + Seconds.text(time) + " s";
        }
    }

    private final Run run;
    private final Optional<Duration> time;
    private final String name;
    private final Function<Run, T> reading;
    private final Duration begin;
    private Moment<T> smallest;
    private Moment<T> largest;
    private Moment<T> last;

    Course(Run run, Optional<Duration> time, String name, Function<Run, T> reading) {
        this.run = run;
        this.time = time;
        this.name = name;
        this.reading = reading;
        begin = run.time();
    }

    /** Lets time pass until the value satisfies a condition; whether it did. */
    boolean until(Predicate<? super T> condition) {
        Duration limit = time.orElse(Duration.ofNanos(Long.MAX_VALUE - begin.toNanos()));
        return run.advanceUntil(now -> condition.test(read()), limit);
    }

    private T read() {
        T value = reading.apply(run);
        last = new Moment<>(run.time(), value);
        if (value instanceof Comparable<?>) {
            smallest = smallest == null || compare(value, smallest.value()) < 0 ? last : smallest;
            largest = largest == null || compare(value, largest.value()) > 0 ? last : largest;
        }
        return value;
    }

    @SuppressWarnings("unchecked")
    private int compare(T one, T other) {
        return ((Comparable<T>) one).compareTo(other);
    }

    AssertionFailedError failure(String kind, String condition) {
        StringBuilder text = new StringBuilder("\nExpecting");
        text.append(name.isEmpty() ? " the run" : " " + name).append("\n  ").append(kind).append(": ")
                .append(condition);
        time.ifPresent(limit -> text.append("\n  within ").append(Seconds.text(limit))
                .append(" simulated seconds from ")
                .append(Seconds.text(begin)).append(" s on"));
        text.append("\nbut at ").append(Seconds.text(last.time())).append(" simulated seconds ");
        text.append(name.isEmpty() ? "it " + (kind.equals("never") ? "did" : "did not") : "it was\n  " + last.value());
        if (!name.isEmpty() && smallest != null && smallest != largest) {
            text.append("\nseen on the way: smallest ").append(smallest).append(", largest ").append(largest);
        }
        if (run.ended()) {
            text.append("\nthe run had ended: ").append(run.outcome().kind());
            run.outcome().error().ifPresent(error -> text.append('\n').append(error));
        }
        return new AssertionFailedError(text.toString());
    }
}
