package brickless.kernel.hooks;

/**
 * Thrown out of every kernel entry once the program is being ended; rewritten handlers let it pass. Has no stack trace.
 */
public final class ProgramKilled extends Error {
    private static final long serialVersionUID = 1L;

    /** Creates the error. */
    public ProgramKilled() {
        super("program ended", null, false, false);
    }
}
