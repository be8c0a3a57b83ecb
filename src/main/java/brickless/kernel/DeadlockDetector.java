package brickless.kernel;

/**
 * Finds threads that can never go on.
 *
 * <p>All of a program: nobody is ready, no time-out is set and nobody waits for a device. Some of it: a cycle in the
 * graph of who waits for whom, through owners of monitors and locks and threads being joined. Monitors cannot be given up, so a
 * cycle of them is final at once; a cycle with a {@code join} could still be broken by an interrupt and is given
 * {@value #GRACE_NANOS} ns. Waits with a time-out, for {@code notify}, for {@code unpark} or for a device are no
 * edges.
 */
final class DeadlockDetector {
    /** Assumption: a program that means to interrupt a joining thread does so within ten seconds. */
    static final long GRACE_NANOS = 10_000_000_000L;

    private final Scheduler scheduler;
    private final VirtualClock clock;
    private final Ending ending;
    private final Roster roster;

    DeadlockDetector(Scheduler scheduler, VirtualClock clock, Ending ending, Roster roster) {
        this.scheduler = scheduler;
        this.clock = clock;
        this.ending = ending;
        this.roster = roster;
    }

    /** Looks for a cycle through a fibre that blocks now. */
    void blocked(Fibre fibre) {
        if (fibre.state == FibreState.SLEEPING || waitsFor(fibre) == null || !inCycle(fibre)) {
            return;
        }
        if (cycleHasJoin(fibre)) {
            long blocks = fibre.blocks;
            Event secondLook = new Event(() -> blockedStill(fibre, blocks));
            clock.schedule(secondLook, VirtualClock.saturatedSum(clock.now(), GRACE_NANOS));
        } else {
            declare();
        }
    }

    /** Ends the program as deadlocked. */
    void declare() {
        ThreadDump dump = new ThreadDump("deadlock", clock.now(), scheduler.backend());
        ending.kill(ProgramEnd.Kind.DEADLOCK, clock.now(), 0, dump.of(roster.live()));
    }

    private void blockedStill(Fibre fibre, long blocks) {
        if (fibre.blocks == blocks && inCycle(fibre)) {
            declare();
        }
    }

    private boolean inCycle(Fibre start) {
        Fibre fibre = waitsFor(start);
        for (int i = roster.live().size(); fibre != null && i > 0; i--) {
            if (fibre == start) {
                return true;
            }
            fibre = waitsFor(fibre);
        }
        return false;
    }

    private boolean cycleHasJoin(Fibre start) {
        Fibre fibre = start;
        do {
            if (fibre.state == FibreState.JOINING) {
                return true;
            }
            fibre = waitsFor(fibre);
        } while (fibre != start);
        return false;
    }

    /**
     * The one fibre without which this one cannot go on, or null. A thread that joins itself just wants to wait for
     * ever.
     */
    private Fibre waitsFor(Fibre fibre) {
        return switch (fibre.state) {
            case BLOCKED -> fibre.monitor.owner;
            case JOINING -> fibre.timeout.queued() || fibre.joined == fibre ? null : fibre.joined;
            case WAITING -> fibre.blocker == null ? null : roster.of(fibre.blocker.lockOwner());
            default -> null;
        };
    }
}
