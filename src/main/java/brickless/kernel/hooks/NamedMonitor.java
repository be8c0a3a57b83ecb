package brickless.kernel.hooks;

/** A lock that no object of the program stands for, with what to call it in a report. Shared. */
public interface NamedMonitor {
    /** Comes after "BLOCKED on". */
    String monitorName();
}
