package brickless.trace;

import java.util.ArrayList;
import java.util.List;

/** Everything a trace tells, kept for assertions. */
public final class CollectedTrace implements TraceListener {
    /** An event with its time and robot. */
    public record Happening(long timeNanos, String robot, TraceEvent event) {}

    /** The header. */
    public TraceHeader header;
    /** The samples in order. */
    public final List<Sample> samples = new ArrayList<>();
    /** The events in order. */
    public final List<Happening> events = new ArrayList<>();

    @Override
    public void header(TraceHeader value) {
        header = value;
    }

    @Override
    public void sample(Sample sample) {
        samples.add(sample);
    }

    @Override
    public void event(long timeNanos, String robot, TraceEvent event) {
        events.add(new Happening(timeNanos, robot, event));
    }
}
