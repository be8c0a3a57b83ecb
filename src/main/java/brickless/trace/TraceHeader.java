package brickless.trace;

import java.util.List;

/**
 * What a run was made of; nothing of the host enters it.
 *
 * @param main main class
 * @param world name of the world
 * @param robots names of the robots' models
 * @param seed seed of the run
 * @param scheduleSeed seed of the schedule, −1 for round-robin
 * @param ideal whether noise, latency and slip were off
 * @param stepNanos physics step
 * @param sampleNanos time between samples
 */
public record TraceHeader(String main, String world, List<String> robots, long seed, long scheduleSeed, boolean ideal,
        long stepNanos, long sampleNanos) {
    /** Version of the trace format. */
    public static final int VERSION = 1;

    public TraceHeader {
        robots = List.copyOf(robots);
    }

    /** Writes the fields of the header. */
    public void write(JsonLine line) {
        line.integer("version", VERSION).text("main", main).text("world", world).texts("robots", robots)
                .integer("seed", seed)
                .integer("scheduleSeed", scheduleSeed).flag("ideal", ideal).seconds("step", stepNanos)
                .seconds("sample", sampleNanos);
    }
}
