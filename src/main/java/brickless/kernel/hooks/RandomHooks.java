package brickless.kernel.hooks;

import java.security.SecureRandom;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.UUID;

/** Randomness of rewritten code: everything comes from the robot's seeded stream. Per robot. */
public final class RandomHooks {
    private static final int DOUBLE_BITS = 53;
    private static final long VERSION_MASK = 0xFFFF_FFFF_FFFF_0FFFL;
    private static final long VERSION_4 = 0x4000L;
    private static final long VARIANT_MASK = 0x3FFF_FFFF_FFFF_FFFFL;
    private static final long VARIANT_IETF = 0x8000_0000_0000_0000L;

    private RandomHooks() {}

    /** {@code Math.random}. */
    public static double random() {
        return (seed() >>> Long.SIZE - DOUBLE_BITS) * 0x1.0p-53;
    }

    /** The seed of {@code new Random()} and {@code new SplittableRandom()}. */
    public static long seed() {
        return Hooks.machine().nextRandomLong();
    }

    /** {@code Random::new}. */
    public static Random newRandom() {
        return new Random(seed());
    }

    /** {@code UUID.randomUUID}. */
    public static UUID randomUUID() {
        return new UUID(seed() & VERSION_MASK | VERSION_4, seed() & VARIANT_MASK | VARIANT_IETF);
    }

    /** {@code SecureRandom.getInstanceStrong}. */
    public static SecureRandom secureRandom() {
        return new ProgramSecureRandom();
    }

    /** {@code SecureRandom.getInstance(algorithm)}. */
    public static SecureRandom secureRandom(String algorithm) {
        return new ProgramSecureRandom();
    }

    /** {@code Collections.shuffle(list)}. */
    public static void shuffle(List<?> list) {
        Collections.shuffle(list, newRandom());
    }
}
