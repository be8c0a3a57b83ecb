package brickless.kernel;

/**
 * Spreads seeds: generators of {@link java.util.Random} whose seeds are near each other begin with almost the same
 * numbers.
 */
final class Seeds {
    private static final int SHIFT = 33;
    private static final long FIRST_FACTOR = 0xff51afd7ed558ccdL;
    private static final long SECOND_FACTOR = 0xc4ceb9fe1a85ec53L;

    private Seeds() {
    }

    /**
     * A seed that has nothing visible in common with those of the neighbours of {@code seed} (the 64-bit finalizer of
     * MurmurHash3).
     */
    static long spread(long seed) {
        long mixed = seed + 1;
        mixed = (mixed ^ mixed >>> SHIFT) * FIRST_FACTOR;
        mixed = (mixed ^ mixed >>> SHIFT) * SECOND_FACTOR;
        return mixed ^ mixed >>> SHIFT;
    }
}
