package brickless.kernel;

import brickless.kernel.hooks.ProgramKilled;

/**
 * Whether and how a program is being ended. The first verdict stands.
 *
 * <p>Written by the running fibre, and by the host watchdog when there is a runaway; read by both.
 */
final class Ending {
    private volatile boolean killing;
    private volatile boolean abandoned;
    /** Written before {@link #killing}. */
    private ProgramEnd end;
    private Throwable failure;
    private Throwable hostFailure;

    boolean killing() {
        return killing;
    }

    /**
     * Whether the host gave the running fibre up: it may still run, so nothing of the kernel may be touched any more.
     */
    boolean abandoned() {
        return abandoned;
    }

    void throwIfKilling() {
        if (killing) {
            throw new ProgramKilled();
        }
    }

    /** Remembers the first exception that the program did not catch. */
    synchronized void uncaught(Throwable thrown) {
        if (failure == null) {
            failure = thrown;
        }
    }

    /** Ends the program; an earlier uncaught exception turns an ordinary end into a failure. */
    synchronized void kill(ProgramEnd.Kind kind, long timeNanos, int status, String dump) {
        if (!killing) {
            boolean ordinary = kind == ProgramEnd.Kind.EXITED || kind == ProgramEnd.Kind.TIME_LIMIT;
            ProgramEnd.Kind verdict = ordinary && failure != null ? ProgramEnd.Kind.FAILED : kind;
            end = new ProgramEnd(verdict, timeNanos, status, failure, dump);
            killing = true;
        }
    }

    /** Ends the program because the simulation around it threw: the run has no result. */
    synchronized void hostFailed(Throwable thrown, long timeNanos) {
        if (hostFailure == null && !abandoned) {
            hostFailure = thrown;
        }
        kill(ProgramEnd.Kind.TIME_LIMIT, timeNanos, 0, "");
    }

    synchronized void abandon(long timeNanos, String dump) {
        abandoned = true;
        kill(ProgramEnd.Kind.RUNAWAY, timeNanos, 0, dump);
    }

    synchronized Throwable hostFailure() {
        return hostFailure;
    }

    /** The verdict; null while the program runs. */
    ProgramEnd end() {
        return killing ? end : null;
    }
}
