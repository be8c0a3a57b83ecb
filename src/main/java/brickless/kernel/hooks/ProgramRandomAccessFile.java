package brickless.kernel.hooks;

import java.io.Closeable;
import java.io.DataInput;
import java.io.DataInputStream;
import java.io.DataOutput;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.File;
import java.io.FileDescriptor;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.OpenOption;
import java.nio.file.StandardOpenOption;

/**
 * What {@code RandomAccessFile} is in a rewritten program: a file of the brick to read and write anywhere. Per robot.
 */
public class ProgramRandomAccessFile implements DataInput, DataOutput, Closeable {
    private static final OpenOption[] READ = {StandardOpenOption.READ};
    private static final OpenOption[] READ_AND_WRITE = {StandardOpenOption.READ, StandardOpenOption.WRITE,
        StandardOpenOption.CREATE};

    private final FileChannel channel;
    private final boolean writable;
    private final FileDescriptor descriptor = new FileDescriptor();
    private final DataInputStream in = new DataInputStream(new Input());
    private final DataOutputStream out = new DataOutputStream(new Output());

    /**
     * Opens a file.
     *
     * @param mode {@code r}, {@code rw}, {@code rws} or {@code rwd}
     */
    public ProgramRandomAccessFile(String name, String mode) throws FileNotFoundException {
        channel = FileHooks.open(name, options(mode));
        writable = !mode.equals("r");
    }

    /** Opens a file; see {@link #ProgramRandomAccessFile(String, String)}. */
    public ProgramRandomAccessFile(File file, String mode) throws FileNotFoundException {
        this(file.getPath(), mode);
    }

    private static OpenOption[] options(String mode) {
        switch (mode) {
            case "r":
                return READ;
            case "rw":
            case "rws":
            case "rwd":
                return READ_AND_WRITE;
            default:
                throw new IllegalArgumentException("Illegal mode \"" + mode
                        + "\" must be one of \"r\", \"rw\", \"rws\", or \"rwd\"");
        }
    }

    private FileChannel open() throws IOException {
        if (!channel.isOpen()) {
            throw new IOException("Stream Closed");
        }
        return channel;
    }

    private FileChannel openToWrite() throws IOException {
        if (!writable) {
            throw new IOException("Bad file descriptor");
        }
        return open();
    }

    /** A descriptor, good for {@code sync} only. */
    public final FileDescriptor getFD() {
        return descriptor;
    }

    /** The file's channel; it shares the position with this object. */
    public final FileChannel getChannel() {
        return channel;
    }

    /** Position in bytes from the beginning. */
    public long getFilePointer() throws IOException {
        return open().position();
    }

    /** Sets the position, which may lie behind the end. */
    public void seek(long position) throws IOException {
        if (position < 0) {
            throw new IOException("Negative seek offset");
        }
        open().position(position);
    }

    /** Length in bytes. */
    public long length() throws IOException {
        return open().size();
    }

    /** Cuts the file, or extends it with zeros. */
    public void setLength(long length) throws IOException {
        if (length <= openToWrite().size()) {
            channel.truncate(length);
            return;
        }
        channel.write(ByteBuffer.allocate(1), length - 1);
    }

    /** Reads a byte; -1 at the end. */
    public int read() throws IOException {
        return in.read();
    }

    /** Reads some bytes; returns their number, or -1 at the end. */
    public int read(byte[] bytes) throws IOException {
        return read(bytes, 0, bytes.length);
    }

    /** Reads some bytes; returns their number, or -1 at the end. */
    public int read(byte[] bytes, int offset, int length) throws IOException {
        return open().read(ByteBuffer.wrap(bytes, offset, length));
    }

    @Override
    public void write(int b) throws IOException {
        write(new byte[] {(byte) b}, 0, 1);
    }

    @Override
    public void write(byte[] bytes) throws IOException {
        write(bytes, 0, bytes.length);
    }

    @Override
    public void write(byte[] bytes, int offset, int length) throws IOException {
        for (ByteBuffer buffer = ByteBuffer.wrap(bytes, offset, length); buffer.hasRemaining();) {
            openToWrite().write(buffer);
        }
    }

    @Override
    public int skipBytes(int count) throws IOException {
        long before = getFilePointer();
        seek(Math.max(before, Math.min(length(), before + Math.max(0, count))));
        return (int) (getFilePointer() - before);
    }

    @Override
    public final void readFully(byte[] bytes) throws IOException {
        in.readFully(bytes);
    }

    @Override
    public final void readFully(byte[] bytes, int offset, int length) throws IOException {
        in.readFully(bytes, offset, length);
    }

    @Override
    public final boolean readBoolean() throws IOException {
        return in.readBoolean();
    }

    @Override
    public final byte readByte() throws IOException {
        return in.readByte();
    }

    @Override
    public final int readUnsignedByte() throws IOException {
        return in.readUnsignedByte();
    }

    @Override
    public final short readShort() throws IOException {
        return in.readShort();
    }

    @Override
    public final int readUnsignedShort() throws IOException {
        return in.readUnsignedShort();
    }

    @Override
    public final char readChar() throws IOException {
        return in.readChar();
    }

    @Override
    public final int readInt() throws IOException {
        return in.readInt();
    }

    @Override
    public final long readLong() throws IOException {
        return in.readLong();
    }

    @Override
    public final float readFloat() throws IOException {
        return in.readFloat();
    }

    @Override
    public final double readDouble() throws IOException {
        return in.readDouble();
    }

    /** A line of characters of one byte each; ends at line feed, carriage return or both. Null at the end. */
    @Override
    public final String readLine() throws IOException {
        StringBuilder line = new StringBuilder();
        int c = read();
        if (c < 0) {
            return null;
        }
        for (; c >= 0 && c != '\n' && c != '\r'; c = read()) {
            line.append((char) c);
        }
        long afterReturn = getFilePointer();
        if (c == '\r' && read() != '\n') {
            seek(afterReturn);
        }
        return line.toString();
    }

    /** @throws EOFException if the file ends within the text */
    @Override
    public final String readUTF() throws IOException {
        return in.readUTF();
    }

    @Override
    public final void writeBoolean(boolean value) throws IOException {
        out.writeBoolean(value);
    }

    @Override
    public final void writeByte(int value) throws IOException {
        out.writeByte(value);
    }

    @Override
    public final void writeShort(int value) throws IOException {
        out.writeShort(value);
    }

    @Override
    public final void writeChar(int value) throws IOException {
        out.writeChar(value);
    }

    @Override
    public final void writeInt(int value) throws IOException {
        out.writeInt(value);
    }

    @Override
    public final void writeLong(long value) throws IOException {
        out.writeLong(value);
    }

    @Override
    public final void writeFloat(float value) throws IOException {
        out.writeFloat(value);
    }

    @Override
    public final void writeDouble(double value) throws IOException {
        out.writeDouble(value);
    }

    @Override
    public final void writeBytes(String text) throws IOException {
        out.writeBytes(text);
    }

    @Override
    public final void writeChars(String text) throws IOException {
        out.writeChars(text);
    }

    @Override
    public final void writeUTF(String text) throws IOException {
        out.writeUTF(text);
    }

    @Override
    public void close() throws IOException {
        channel.close();
    }

    /** What data are put together from. */
    private final class Input extends InputStream {
        @Override
        public int read() throws IOException {
            byte[] single = new byte[1];
            return read(single, 0, 1) < 0 ? -1 : single[0] & 0xff;
        }

        @Override
        public int read(byte[] bytes, int offset, int length) throws IOException {
            return ProgramRandomAccessFile.this.read(bytes, offset, length);
        }
    }

    /** Where data go in pieces. */
    private final class Output extends OutputStream {
        @Override
        public void write(int b) throws IOException {
            ProgramRandomAccessFile.this.write(b);
        }

        @Override
        public void write(byte[] bytes, int offset, int length) throws IOException {
            ProgramRandomAccessFile.this.write(bytes, offset, length);
        }
    }
}
