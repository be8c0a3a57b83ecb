package brickless.hardware;

/** What the program tells the outside. Nothing here blocks or throws. */
public interface ProgramLog {
    /**
     * Bytes the program printed to {@code System.out} ({@code error} false) or {@code System.err} (true), in the order
     * printed.
     */
    void printed(byte[] bytes, int offset, int length, boolean error);

    /** A thread of the program ended with an exception that no handler of the program took. */
    void uncaught(Thread thread, Throwable failure);

    /**
     * An arbitrator was created.
     *
     * @param behaviours class names in order of priority, lowest first
     * @return number of this arbitrator on this brick, from 0
     */
    int arbitratorCreated(String[] behaviours);

    /** The highest behaviour that wants control changed; −1 = none. */
    void behaviourWanted(int arbitrator, int behaviour);

    /** The behaviour whose action runs changed; −1 = none. */
    void behaviourActive(int arbitrator, int behaviour);

    /** {@code suppress()} was called on the active behaviour for the first time during its present action. */
    void behaviourSuppressed(int arbitrator, int behaviour);

    /** Ends the program as {@code System.exit} would; used by the DOWN+ENTER combination. */
    void endProgram(int status);
}
