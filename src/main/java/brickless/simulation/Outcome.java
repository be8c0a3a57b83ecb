package brickless.simulation;

import java.util.Optional;

/**
 * How a run ended.
 *
 * @param kind {@code exited}, {@code time-limit}, {@code goal-reached}, {@code failed}, {@code deadlock} or
 *         {@code runaway}
 * @param exitStatus status of {@code System.exit} for {@code exited}
 * @param timeNanos simulated time
 * @param error what went wrong, in terms of the program: exception with the program's own lines, or a dump of its
 *         threads
 */
public record Outcome(String kind, Optional<Integer> exitStatus, long timeNanos, Optional<String> error) {
    /** Whether the run counts as a success when no goal was asked for. */
    public boolean successful() {
        return switch (kind) {
            case "exited" -> exitStatus.orElse(0) == 0;
            case "time-limit", "goal-reached" -> true;
            default -> false;
        };
    }
}
