package brickless.loading;

/**
 * A class of the program that cannot run here: damaged, compiled for a newer Java, or too large. One line says which
 * and where it is.
 */
public final class UnloadableClassError extends LinkageError {
    private static final long serialVersionUID = 1L;

    UnloadableClassError(String internalName, String origin, String reason, Throwable cause) {
        super(internalName.replace('/', '.') + " (" + origin + "): " + reason, cause);
    }
}
