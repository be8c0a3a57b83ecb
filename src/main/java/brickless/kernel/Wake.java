package brickless.kernel;

/** Why a blocked fibre goes on. */
enum Wake {
    /** What it waited for happened. */
    RESUMED,
    TIMED_OUT,
    INTERRUPTED
}
