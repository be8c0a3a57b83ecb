package brickless.viewer;

/** A command that cannot be carried out; the message is one sentence for the viewer. */
final class RefusedException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    RefusedException(String message) {
        super(message);
    }
}
