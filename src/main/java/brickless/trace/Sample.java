package brickless.trace;

import java.util.List;

/** The whole arena at one instant. Bodies that did not move since the previous sample may be left out. */
public record Sample(long timeNanos, List<RobotSample> robots, List<BodySample> bodies) {
    public Sample {
        robots = List.copyOf(robots);
        bodies = List.copyOf(bodies);
    }
}
