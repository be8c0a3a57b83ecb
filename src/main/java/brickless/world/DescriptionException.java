package brickless.world;

/**
 * A world, robot or stimuli file that cannot be used. The message is one line: file, line, element id, what is wrong,
 * what is allowed.
 */
public final class DescriptionException extends Exception {
    private static final long serialVersionUID = 1L;

    /**
     * Creates the error.
     *
     * @param file file name as the user gave it
     * @param line line number from 1, or 0 if unknown
     * @param element element id or name, may be empty
     * @param message what is wrong and what is allowed
     */
    public DescriptionException(String file, int line, String element, String message) {
        super(file + (line > 0 ? ":" + line : "") + ": " + (element.isEmpty() ? "" : element + ": ") + message);
    }
}
