package brickless.kernel.hooks;

import java.io.File;
import java.io.FileDescriptor;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.OpenOption;
import java.nio.file.StandardOpenOption;

/** What {@code FileOutputStream} is in a rewritten program: writes a file of the brick, or the console. Per robot. */
public class ProgramFileOutputStream extends OutputStream {
    /** Null for the console. */
    private final FileChannel channel;
    private final OutputStream console;
    private final FileDescriptor descriptor;

    /** Writes a new file. */
    public ProgramFileOutputStream(String name) throws FileNotFoundException {
        this(name, false);
    }

    /** Writes or extends a file. */
    public ProgramFileOutputStream(String name, boolean append) throws FileNotFoundException {
        OpenOption how = append ? StandardOpenOption.APPEND : StandardOpenOption.TRUNCATE_EXISTING;
        channel = FileHooks.open(name, StandardOpenOption.WRITE, StandardOpenOption.CREATE, how);
        console = null;
        descriptor = new FileDescriptor();
    }

    /** Writes a new file. */
    public ProgramFileOutputStream(File file) throws FileNotFoundException {
        this(file.getPath(), false);
    }

    /** Writes or extends a file. */
    public ProgramFileOutputStream(File file, boolean append) throws FileNotFoundException {
        this(file.getPath(), append);
    }

    /**
     * Writes to the program's console.
     *
     * @throws UnsupportedOperationException if the descriptor is neither {@code FileDescriptor.out} nor {@code err}
     */
    public ProgramFileOutputStream(FileDescriptor descriptor) {
        if (descriptor != FileDescriptor.out && descriptor != FileDescriptor.err) {
            throw new UnsupportedOperationException("descriptors of a simulated brick's files open nothing; use the "
                    + "name");
        }
        channel = null;
        console = descriptor == FileDescriptor.out ? Hooks.machine().out() : Hooks.machine().err();
        this.descriptor = descriptor;
    }

    @Override
    public void write(int b) throws IOException {
        write(new byte[] {(byte) b}, 0, 1);
    }

    @Override
    public void write(byte[] bytes, int offset, int length) throws IOException {
        if (channel == null) {
            console.write(bytes, offset, length);
            return;
        }
        if (!channel.isOpen()) {
            throw new IOException("Stream Closed");
        }
        for (ByteBuffer buffer = ByteBuffer.wrap(bytes, offset, length); buffer.hasRemaining();) {
            channel.write(buffer);
        }
    }

    /**
     * The file's channel; it shares the position with the stream.
     *
     * @throws UnsupportedOperationException for the console
     */
    public FileChannel getChannel() {
        if (channel == null) {
            throw new UnsupportedOperationException("the console of a simulated brick has no channel");
        }
        return channel;
    }

    /** A descriptor, good for {@code sync} only. */
    public final FileDescriptor getFD() {
        return descriptor;
    }

    /** Closes the file; the console stays open. */
    @Override
    public void close() throws IOException {
        if (channel != null) {
            channel.close();
        }
    }
}
