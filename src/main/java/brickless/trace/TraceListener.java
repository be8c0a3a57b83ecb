package brickless.trace;

/** Hears a run from beginning to end: first the header, then samples and events in the order of the trace. */
public interface TraceListener {
    /** Listens to nothing. */
    TraceListener NONE = new TraceListener() {
        @Override
        public void header(TraceHeader header) {
            // Nobody is interested.
        }

        @Override
        public void sample(Sample sample) {
            // Nobody is interested.
        }

        @Override
        public void event(long timeNanos, String robot, TraceEvent event) {
            // Nobody is interested.
        }
    };

    /** What the run is made of. */
    void header(TraceHeader header);

    /** Where everything was at one instant. */
    void sample(Sample sample);

    /** Something happened to or on one robot. */
    void event(long timeNanos, String robot, TraceEvent event);
}
