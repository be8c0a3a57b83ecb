package brickless.simulation;

import brickless.kernel.ProgramEnd;
import brickless.trace.Decimals;
import java.util.List;
import java.util.Optional;

/** Makes the outcome of a run out of how its programs ended. */
final class OutcomeOf {
    /** What counts more comes first when several programs ended differently. */
    private static final List<ProgramEnd.Kind> SEVERITY = List.of(ProgramEnd.Kind.RUNAWAY, ProgramEnd.Kind.DEADLOCK,
            ProgramEnd.Kind.FAILED, ProgramEnd.Kind.GOAL_REACHED, ProgramEnd.Kind.TIME_LIMIT, ProgramEnd.Kind.EXITED);

    private OutcomeOf() {}

    static Outcome programs(List<RobotSession> sessions, List<ProgramEnd> ends) {
        int decisive = 0;
        for (int i = 1; i < ends.size(); i++) {
            if (severity(sessions.get(i), ends.get(i)) < severity(sessions.get(decisive), ends.get(decisive))) {
                decisive = i;
            }
        }
        ProgramEnd end = ends.get(decisive);
        ProgramEnd.Kind kind = kind(sessions.get(decisive), end);
        Optional<Integer> status = kind == ProgramEnd.Kind.EXITED ? Optional.of(end.status()) : Optional.empty();
        return new Outcome(kind.text(), status, end.timeNanos(), error(sessions.get(decisive), end));
    }

    private static int severity(RobotSession session, ProgramEnd end) {
        return SEVERITY.indexOf(kind(session, end));
    }

    /**
     * A program that ended or timed out after an exception nobody handled has failed, though the brick let its other
     * threads go on.
     */
    private static ProgramEnd.Kind kind(RobotSession session, ProgramEnd end) {
        boolean quiet = end.kind() == ProgramEnd.Kind.EXITED || end.kind() == ProgramEnd.Kind.TIME_LIMIT;
        return quiet && session.console().failure().isPresent() ? ProgramEnd.Kind.FAILED : end.kind();
    }

    private static Optional<String> error(RobotSession session, ProgramEnd end) {
        return switch (kind(session, end)) {
            case DEADLOCK, RUNAWAY -> Optional.of(end.dump().strip());
            case FAILED -> Optional.of(session.console().failure().orElseGet(() -> described(end)));
            default -> Optional.empty();
        };
    }

    private static String described(ProgramEnd end) {
        return end.failure() instanceof RobotFellException
                ? end.failure().getMessage() + " after " + Decimals.seconds(end.timeNanos()) + " simulated seconds"
                : ProgramFailure.describe("main", end.failure(), end.timeNanos());
    }
}
