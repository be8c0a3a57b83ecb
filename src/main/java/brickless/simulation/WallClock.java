package brickless.simulation;

/**
 * The only place of the simulation that looks at the host's clock: to say how fast a run was. Nothing of it reaches a
 * program or a trace.
 */
final class WallClock {
    private final long started = System.nanoTime();

    double elapsedSeconds() {
        return (System.nanoTime() - started) / 1e9;
    }
}
