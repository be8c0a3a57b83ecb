package lejos.utility;

/** Measures time in milliseconds from its creation or its last reset. */
public class Stopwatch {
    private long startMillis;

    /** Starts the watch. */
    public Stopwatch() {
        reset();
    }

    /** Starts the watch anew. */
    public void reset() {
        startMillis = System.currentTimeMillis();
    }

    /** Milliseconds since the start; wraps after about 24.8 days. */
    public int elapsed() {
        return (int) (System.currentTimeMillis() - startMillis);
    }
}
