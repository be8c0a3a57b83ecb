package brickless.kernel;

/** Who goes on when a kernel's program has ended. */
interface Turns {
    /**
     * The fibre of another kernel to go on with, or null if all have ended. Called on the stack of the last fibre of
     * {@code kernel}.
     */
    Fibre nextAfterEnd(Kernel kernel);
}
