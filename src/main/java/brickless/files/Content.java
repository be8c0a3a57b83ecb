package brickless.files;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;

/**
 * A file: bytes that the program wrote, or, until it changes them, those of a file of the host that are read when they
 * are needed first. A deleted file lives on for those who have it open.
 */
final class Content extends Entry {
    private static final int FIRST_BYTES = 256;

    private final Card card;
    private Path original;
    private byte[] bytes = new byte[0];
    private int size;
    private boolean changed;
    private boolean deleted;

    private Content(Card card, long modifiedMillis) {
        super(modifiedMillis);
        this.card = card;
    }

    /** A new, empty file. */
    static Content empty(Card card, long modifiedMillis) {
        Content content = new Content(card, modifiedMillis);
        content.changed = true;
        return content;
    }

    /** A file that the user put on the brick. */
    static Content of(Path original, int size, Card card, long modifiedMillis) {
        Content content = new Content(card, modifiedMillis);
        content.original = original;
        content.size = size;
        return content;
    }

    /** The same bytes once more, as a file that the program made. */
    Content copy(long nowMillis) throws IOException {
        Content copy = empty(card, nowMillis);
        copy.write(0, ByteBuffer.wrap(bytes()));
        return copy;
    }

    int size() {
        return size;
    }

    /** Whether the program made or changed it. */
    boolean changed() {
        return changed;
    }

    /** All bytes. */
    byte[] bytes() throws IOException {
        load();
        return Arrays.copyOf(bytes, size);
    }

    /** Reads at a position. Returns the number of bytes, or -1 at or behind the end. */
    int read(long position, ByteBuffer target) throws IOException {
        load();
        if (position >= size) {
            return target.hasRemaining() ? -1 : 0;
        }
        int count = Math.min(target.remaining(), size - (int) position);
        target.put(bytes, (int) position, count);
        return count;
    }

    /** Writes at a position; a gap before it is filled with zeros. */
    int write(long position, ByteBuffer source) throws IOException {
        change();
        int count = source.remaining();
        if (count > 0) {
            grow(position + count);
            source.get(bytes, (int) position, count);
        }
        return count;
    }

    /** Sets the length, filling with zeros or cutting. */
    void resize(long newSize) throws IOException {
        change();
        if (newSize > size) {
            grow(newSize);
        } else {
            Arrays.fill(bytes, (int) newSize, size, (byte) 0);
            giveBack(size - newSize);
            size = (int) newSize;
        }
    }

    /** From now on it counts as made by the program. */
    void change() throws IOException {
        load();
        if (!changed) {
            card.take(size);
            changed = true;
        }
    }

    /** It is in no folder any more. */
    void delete() {
        if (changed) {
            giveBack(size);
        }
        deleted = true;
    }

    private void giveBack(long count) {
        if (!deleted) {
            card.giveBack(count);
        }
    }

    private void grow(long newSize) throws IOException {
        if (newSize <= size) {
            return;
        }
        if (!deleted) {
            card.take(newSize - size);
        } else if (newSize > BrickFiles.CAPACITY_BYTES) {
            throw new IOException("No space left on device");
        }
        if (newSize > bytes.length) {
            bytes = Arrays.copyOf(bytes, (int) Math.max(newSize, Math.max(FIRST_BYTES, bytes.length * 2L)));
        }
        size = (int) newSize;
    }

    private void load() throws IOException {
        if (original != null) {
            bytes = Files.readAllBytes(original);
            size = bytes.length;
            original = null;
        }
    }
}
