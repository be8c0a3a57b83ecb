package lejos.robotics.subsumption;

import brickless.hardware.BrickAccess;
import brickless.hardware.BrickHardware;
import brickless.hardware.ProgramLog;
import java.util.Arrays;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Tells the log, and the brick if there is one, what changes in an arbitrator. Guarded by the arbitrator's lock. */
final class ArbitrationReport {
    private static final Logger LOGGER = LoggerFactory.getLogger(Arbitrator.class);
    private static final int NONE = -1;

    private final String[] names;
    private final ProgramLog log;
    private final int arbitrator;
    private int wanted = NONE;
    private int active = NONE;
    private boolean suppressed;

    ArbitrationReport(Behavior[] behaviors) {
        names = Arrays.stream(behaviors).map(b -> b == null ? "null" : b.getClass().getName()).toArray(String[]::new);
        log = BrickAccess.present().map(BrickHardware::log).orElse(null);
        arbitrator = log == null ? 0 : log.arbitratorCreated(names.clone());
    }

    /** The highest behaviour that wants control, or −1. */
    void wanted(int behavior) {
        if (behavior == wanted) {
            return;
        }
        wanted = behavior;
        LOGGER.debug("wanted: {}", name(behavior));
        if (log != null) {
            log.behaviourWanted(arbitrator, behavior);
        }
    }

    /** The behaviour whose action begins, or −1 when one ended. */
    void active(int behavior) {
        suppressed = false;
        if (behavior == active) {
            return;
        }
        active = behavior;
        LOGGER.debug("active: {}", name(behavior));
        if (log != null) {
            log.behaviourActive(arbitrator, behavior);
        }
    }

    /** The active behaviour is being suppressed; only the first time in an action is news. */
    void suppressed(int behavior) {
        if (suppressed) {
            return;
        }
        suppressed = true;
        LOGGER.debug("suppressed: {}", name(behavior));
        if (log != null) {
            log.behaviourSuppressed(arbitrator, behavior);
        }
    }

    private String name(int behavior) {
        return behavior == NONE ? "none" : names[behavior];
    }
}
