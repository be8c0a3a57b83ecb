package brickless.kernel;

import java.util.Random;

/** Numbers that a JVM would draw from its host: random seeds, identity hash codes, thread numbers and ids. */
final class Identities {
    /**
     * A full-period generator modulo 2^31 (constants of ANSI C's {@code rand}), so that hashes spread over hash
     * tables.
     */
    private static final int HASH_FACTOR = 1_103_515_245;
    private static final int HASH_INCREMENT = 12_345;
    private static final int FIRST_HASH = 0x1000;

    private final Random random;
    private int hash = FIRST_HASH;
    private int threadNumber;
    /** The main thread of a JVM has id 1. */
    private long threadId;

    Identities(long seed) {
        random = new Random(Seeds.spread(seed));
    }

    long nextRandomLong() {
        return random.nextLong();
    }

    /** Positive, never 0, different for the first 2^31 − 1 calls. */
    int nextHash() {
        do {
            hash = hash * HASH_FACTOR + HASH_INCREMENT & Integer.MAX_VALUE;
        } while (hash == 0);
        return hash;
    }

    int nextThreadNumber() {
        return threadNumber++;
    }

    long nextThreadId() {
        return ++threadId;
    }
}
