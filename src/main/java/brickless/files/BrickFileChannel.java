package brickless.files;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.MappedByteBuffer;
import java.nio.channels.ClosedChannelException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.NonReadableChannelException;
import java.nio.channels.NonWritableChannelException;
import java.nio.channels.ReadableByteChannel;
import java.nio.channels.WritableByteChannel;

/** An open file of a brick. Never blocks. Cannot be mapped into memory or locked. */
final class BrickFileChannel extends FileChannel {
    private static final int TRANSFER_BYTES = 8192;

    private final BrickFiles files;
    private final Content content;
    private final OpenMode mode;
    private final Runnable atClose;
    private long position;

    BrickFileChannel(BrickFiles files, Content content, OpenMode mode, Runnable atClose) {
        this.files = files;
        this.content = content;
        this.mode = mode;
        this.atClose = atClose;
    }

    private void checkOpen() throws ClosedChannelException {
        if (!isOpen()) {
            throw new ClosedChannelException();
        }
    }

    private void checkReadable() throws ClosedChannelException {
        checkOpen();
        if (!mode.reads()) {
            throw new NonReadableChannelException();
        }
    }

    private void checkWritable() throws ClosedChannelException {
        checkOpen();
        if (!mode.writes()) {
            throw new NonWritableChannelException();
        }
    }

    private static void checkPosition(long value) {
        if (value < 0) {
            throw new IllegalArgumentException("negative position: " + value);
        }
    }

    @Override
    public int read(ByteBuffer target) throws IOException {
        int count = read(target, position);
        position += Math.max(0, count);
        return count;
    }

    @Override
    public int read(ByteBuffer target, long at) throws IOException {
        checkReadable();
        checkPosition(at);
        return content.read(at, target);
    }

    @Override
    public long read(ByteBuffer[] targets, int offset, int length) throws IOException {
        long total = 0;
        for (int i = offset; i < offset + length; i++) {
            int count = read(targets[i]);
            if (count < 0) {
                return total == 0 ? -1 : total;
            }
            total += count;
        }
        return total;
    }

    @Override
    public int write(ByteBuffer source) throws IOException {
        checkWritable();
        if (mode.appends()) {
            position = content.size();
        }
        int count = write(source, position);
        position += count;
        return count;
    }

    @Override
    public int write(ByteBuffer source, long at) throws IOException {
        checkWritable();
        checkPosition(at);
        int count = content.write(mode.appends() ? content.size() : at, source);
        content.modifiedMillis = files.nowMillis();
        return count;
    }

    @Override
    public long write(ByteBuffer[] sources, int offset, int length) throws IOException {
        long total = 0;
        for (int i = offset; i < offset + length; i++) {
            total += write(sources[i]);
        }
        return total;
    }

    @Override
    public long position() throws IOException {
        checkOpen();
        return mode.appends() && position == 0 ? content.size() : position;
    }

    @Override
    public FileChannel position(long newPosition) throws IOException {
        checkOpen();
        checkPosition(newPosition);
        position = newPosition;
        return this;
    }

    @Override
    public long size() throws IOException {
        checkOpen();
        return content.size();
    }

    @Override
    public FileChannel truncate(long newSize) throws IOException {
        checkWritable();
        checkPosition(newSize);
        if (newSize < content.size()) {
            content.resize(newSize);
            content.modifiedMillis = files.nowMillis();
        }
        position = Math.min(position, newSize);
        return this;
    }

    /** Nothing to do: a brick's memory loses nothing. */
    @Override
    public void force(boolean metaData) throws IOException {
        checkOpen();
    }

    @Override
    public long transferTo(long at, long count, WritableByteChannel target) throws IOException {
        checkReadable();
        checkPosition(at);
        long moved = 0;
        while (moved < count) {
            ByteBuffer buffer = ByteBuffer.allocate((int) Math.min(TRANSFER_BYTES, count - moved));
            if (content.read(at + moved, buffer) <= 0) {
                break;
            }
            buffer.flip();
            moved += target.write(buffer);
        }
        return moved;
    }

    @Override
    public long transferFrom(ReadableByteChannel source, long at, long count) throws IOException {
        checkWritable();
        checkPosition(at);
        long moved = 0;
        while (moved < count) {
            ByteBuffer buffer = ByteBuffer.allocate((int) Math.min(TRANSFER_BYTES, count - moved));
            if (source.read(buffer) <= 0) {
                break;
            }
            buffer.flip();
            moved += write(buffer, at + moved);
        }
        return moved;
    }

    /** @throws UnsupportedOperationException always */
    @Override
    public MappedByteBuffer map(MapMode mapMode, long at, long length) {
        throw new UnsupportedOperationException("files of a simulated brick cannot be mapped into memory");
    }

    /** @throws UnsupportedOperationException always */
    @Override
    public FileLock lock(long at, long length, boolean shared) {
        throw new UnsupportedOperationException("files of a simulated brick cannot be locked: nobody else has them");
    }

    /** @throws UnsupportedOperationException always */
    @Override
    public FileLock tryLock(long at, long length, boolean shared) {
        return lock(at, length, shared);
    }

    @Override
    protected void implCloseChannel() {
        atClose.run();
    }
}
