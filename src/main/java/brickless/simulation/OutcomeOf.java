package brickless.simulation;

import brickless.kernel.ProgramEnd;
import brickless.trace.Decimals;
import java.util.List;
import java.util.Optional;

/** Makes the outcome of a run out of how its programs ended. */
final class OutcomeOf {
    /** What counts more comes first when several programs ended differently. */
    private static final List<ProgramEnd.Kind> SEVERITY = List.of(ProgramEnd.Kind.RUNAWAY, ProgramEnd.Kind.DEADLOCK, ProgramEnd.Kind.FAILED,
            ProgramEnd.Kind.GOAL_REACHED, ProgramEnd.Kind.TIME_LIMIT, ProgramEnd.Kind.EXITED);

    private OutcomeOf() {}

    static Outcome programs(List<RobotSession> sessions, List<ProgramEnd> ends, Journey journey) {
        int decisive = 0;
        for (int i = 1; i < ends.size(); i++) {
            if (SEVERITY.indexOf(ends.get(i).kind()) < SEVERITY.indexOf(ends.get(decisive).kind())) {
                decisive = i;
            }
        }
        ProgramEnd end = ends.get(decisive);
        Optional<Integer> status = end.kind() == ProgramEnd.Kind.EXITED ? Optional.of(end.status()) : Optional.empty();
        return new Outcome(end.kind().text(), status, end.timeNanos(), error(sessions.get(decisive), end));
    }

    private static Optional<String> error(RobotSession session, ProgramEnd end) {
        return switch (end.kind()) {
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
