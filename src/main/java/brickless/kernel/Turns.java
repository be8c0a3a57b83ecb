package brickless.kernel;

/** Who goes on when a kernel has nothing left to do before the next physics step, or at all. */
interface Turns {
    /** The fibre of this or another kernel to go on with, or null if all programs are over. */
    Fibre next();
}
