package brickless.kernel.hooks;

import java.security.SecureRandom;
import java.security.SecureRandomSpi;
import java.util.Random;

/** What {@code new SecureRandom()} becomes in a rewritten program: repeatable, not secure. Per robot. */
public class ProgramSecureRandom extends SecureRandom {
    private static final long serialVersionUID = 1L;

    /** Draws its seed from the robot's stream. */
    public ProgramSecureRandom() {
        super(new SeededSource(), null);
    }

    /** Draws its seed from the robot's stream, whatever the argument: a seed only ever adds to a secure generator. */
    public ProgramSecureRandom(byte[] seed) {
        this();
    }

    private static final class SeededSource extends SecureRandomSpi {
        private static final long serialVersionUID = 1L;
        private final Random source = RandomHooks.newRandom();

        @Override
        protected void engineSetSeed(byte[] seed) {
            // a seed only adds randomness, and this source must stay repeatable
        }

        @Override
        protected void engineNextBytes(byte[] bytes) {
            source.nextBytes(bytes);
        }

        @Override
        protected byte[] engineGenerateSeed(int count) {
            byte[] seed = new byte[count];
            source.nextBytes(seed);
            return seed;
        }
    }
}
