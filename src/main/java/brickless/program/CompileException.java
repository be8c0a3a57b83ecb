package brickless.program;

/** A program that does not compile. */
final class CompileException extends ProgramException {
    private static final long serialVersionUID = 1L;

    CompileException(String message) {
        super(message);
    }
}
