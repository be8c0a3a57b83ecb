package brickless.kernel.hooks;

import java.io.File;
import java.io.FileDescriptor;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.StandardOpenOption;

/** What {@code FileInputStream} is in a rewritten program: reads a file of the brick. Per robot. */
public class ProgramFileInputStream extends InputStream {
    private final FileChannel channel;
    private final FileDescriptor descriptor = new FileDescriptor();

    /** Reads a file. */
    public ProgramFileInputStream(String name) throws FileNotFoundException {
        channel = FileHooks.open(name, StandardOpenOption.READ);
    }

    /** Reads a file. */
    public ProgramFileInputStream(File file) throws FileNotFoundException {
        this(file.getPath());
    }

    /** @throws UnsupportedOperationException always */
    public ProgramFileInputStream(FileDescriptor descriptor) {
        throw new UnsupportedOperationException("descriptors of a simulated brick's files open nothing; use the name");
    }

    private FileChannel open() throws IOException {
        if (!channel.isOpen()) {
            throw new IOException("Stream Closed");
        }
        return channel;
    }

    @Override
    public int read() throws IOException {
        ByteBuffer single = ByteBuffer.allocate(1);
        return open().read(single) < 0 ? -1 : single.get(0) & 0xff;
    }

    @Override
    public int read(byte[] bytes, int offset, int length) throws IOException {
        return open().read(ByteBuffer.wrap(bytes, offset, length));
    }

    @Override
    public long skip(long count) throws IOException {
        long before = open().position();
        channel.position(Math.max(0, before + count));
        return channel.position() - before;
    }

    @Override
    public int available() throws IOException {
        long left = open().size() - channel.position();
        return (int) Math.max(0, Math.min(left, Integer.MAX_VALUE));
    }

    /** The file's channel; it shares the position with the stream. */
    public FileChannel getChannel() {
        return channel;
    }

    /** A descriptor, good for {@code sync} only. */
    public final FileDescriptor getFD() {
        return descriptor;
    }

    @Override
    public void close() throws IOException {
        channel.close();
    }
}
