package brickless.trace;

/** A trace that cannot be read. The message is one line: file, line number, what is wrong. */
public final class TraceException extends Exception {
    private static final long serialVersionUID = 1L;

    TraceException(String file, long line, String message) {
        super(file + (line > 0 ? ":" + line : "") + ": " + message);
    }
}
