package brickless.kernel;

import java.util.Objects;

/**
 * How and when a program ended.
 *
 * @param kind what ended it
 * @param timeNanos virtual time of the end
 * @param status the status for {@code exited}, else 0 (of {@code System.exit}, 0 when the last thread ended)
 * @param failure the first exception that no handler of the program caught, or null; never null for {@code failed}
 * @param dump the program's threads for {@code deadlock} and {@code runaway}, else empty
 */
public record ProgramEnd(Kind kind, long timeNanos, int status, Throwable failure, String dump) {
    /** What ends programs. */
    public enum Kind {
        /** The last thread ended, {@code System.exit} or {@code Runtime.halt}. */
        EXITED("exited"),
        /** The virtual-time limit was reached. */
        TIME_LIMIT("time-limit"),
        /** A step handler saw the goal reached. */
        GOAL_REACHED("goal-reached"),
        /** Ended or timed out after an uncaught exception, or failed by a step handler. */
        FAILED("failed"),
        /** No thread, or some threads, can never go on. */
        DEADLOCK("deadlock"),
        /** The program kept the host busy without ever entering the kernel. */
        RUNAWAY("runaway");

        private final String text;

        Kind(String text) {
            this.text = text;
        }

        /** The name in reports, such as {@code time-limit}. */
        public String text() {
            return text;
        }
    }

    /** Checks the parts. */
    public ProgramEnd {
        Objects.requireNonNull(kind, "kind");
        Objects.requireNonNull(dump, "dump");
        if (kind == Kind.FAILED) {
            Objects.requireNonNull(failure, "failure");
        }
    }
}
