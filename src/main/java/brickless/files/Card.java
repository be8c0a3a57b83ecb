package brickless.files;

import java.io.IOException;

/** The room for what a program writes. */
final class Card {
    private final long capacityBytes;
    private long usedBytes;

    Card(long capacityBytes) {
        this.capacityBytes = capacityBytes;
    }

    void take(long bytes) throws IOException {
        if (bytes > freeBytes()) {
            throw new IOException("No space left on device");
        }
        usedBytes += bytes;
    }

    void giveBack(long bytes) {
        usedBytes -= bytes;
    }

    long freeBytes() {
        return capacityBytes - usedBytes;
    }
}
