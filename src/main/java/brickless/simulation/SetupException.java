package brickless.simulation;

/** A program, world and robot that do not fit together. The message is one line for the user. */
public final class SetupException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    /** Creates the error. */
    public SetupException(String message) {
        super(message);
    }
}
