package brickless.program;

/**
 * A program that cannot be found, compiled or started. The message is for the user: one located line, or the compiler's
 * own messages.
 */
public class ProgramException extends Exception {
    private static final long serialVersionUID = 1L;

    /** Creates the error. */
    public ProgramException(String message) {
        super(message);
    }
}
