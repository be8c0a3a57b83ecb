package brickless.world.svg;

/** A value that cannot be understood; the place is added where the element is known. */
final class MalformedValueException extends Exception {
    private static final long serialVersionUID = 1L;

    MalformedValueException(String message) {
        super(message);
    }
}
