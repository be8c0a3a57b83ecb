package brickless.kernel;

import java.util.concurrent.atomic.AtomicLong;

/**
 * A sign of life for the host watchdog: a number that changes whenever a program enters the kernel, odd while code of
 * the host (a physics step, a pause of the viewer) runs, which is not watched.
 */
final class Heartbeat {
    /** Written by the running fibre only, so plain sums suffice; opaque, because the watchdog reads it. */
    private final AtomicLong beats = new AtomicLong();

    void beat() {
        beats.setOpaque(beats.getPlain() + 2);
    }

    void hostBegins() {
        beats.setOpaque(beats.getPlain() + 1);
    }

    void hostEnds() {
        beats.setOpaque(beats.getPlain() + 1);
    }

    long read() {
        return beats.getOpaque();
    }

    static boolean inHost(long reading) {
        return (reading & 1) != 0;
    }
}
