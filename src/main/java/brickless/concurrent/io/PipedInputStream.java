package brickless.concurrent.io;

import java.io.IOException;
import java.io.InputStream;
import java.util.Objects;

/** {@code java.io.PipedInputStream} on virtual monitors. */
public class PipedInputStream extends InputStream {
    /** Default number of bytes that the pipe holds. */
    protected static final int PIPE_SIZE = 1024;

    private final Pipe pipe;

    /** Creates a stream that reads what is written to {@code src}. */
    public PipedInputStream(PipedOutputStream src) throws IOException {
        this(src, PIPE_SIZE);
    }

    /** Creates a stream that reads what is written to {@code src}, with room for that much. */
    public PipedInputStream(PipedOutputStream src, int pipeSize) throws IOException {
        this(pipeSize);
        connect(src);
    }

    /** Creates a stream that is not connected yet. */
    public PipedInputStream() {
        this(PIPE_SIZE);
    }

    /** Creates a stream that is not connected yet, with room for that much. */
    public PipedInputStream(int pipeSize) {
        pipe = new Pipe(pipeSize);
    }

    /** Connects both ends; IOException if either is connected. */
    public void connect(PipedOutputStream src) throws IOException {
        src.connect(this);
    }

    final Pipe pipe() {
        return pipe;
    }

    /** Stores what the other end writes, waiting for room. */
    protected void receive(int b) throws IOException {
        pipe.write((char) (b & 0xff));
    }

    @Override
    public int read() throws IOException {
        return pipe.read();
    }

    /** Waits for the first byte, then reads what is there. */
    @Override
    public int read(byte[] b, int off, int len) throws IOException {
        Objects.checkFromIndexSize(off, len, b.length);
        synchronized (pipe) {
            int count = 0;
            while (count < len && (count == 0 || pipe.filled() > 0)) {
                int value = read();
                if (value < 0) {
                    return -1;
                }
                b[off + count] = (byte) value;
                count++;
            }
            return count;
        }
    }

    @Override
    public int available() {
        return pipe.filled();
    }

    @Override
    public void close() {
        pipe.closeReader();
    }
}
