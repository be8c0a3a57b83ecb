package brickless.concurrent.io;

import java.io.IOException;
import java.io.Reader;
import java.util.Objects;

/** {@code java.io.PipedReader} on virtual monitors. */
public class PipedReader extends Reader {
    private static final int PIPE_SIZE = 1024;

    private final Pipe pipe;

    /** Creates a stream that reads what is written to {@code src}. */
    public PipedReader(PipedWriter src) throws IOException {
        this(src, PIPE_SIZE);
    }

    /** Creates a stream that reads what is written to {@code src}, with room for that much. */
    public PipedReader(PipedWriter src, int pipeSize) throws IOException {
        this(pipeSize);
        connect(src);
    }

    /** Creates a stream that is not connected yet. */
    public PipedReader() {
        this(PIPE_SIZE);
    }

    /** Creates a stream that is not connected yet, with room for that much. */
    public PipedReader(int pipeSize) {
        pipe = new Pipe(pipeSize);
    }

    /** Connects both ends; IOException if either is connected. */
    public void connect(PipedWriter src) throws IOException {
        src.connect(this);
    }

    final Pipe pipe() {
        return pipe;
    }

    /** Stores what the other end writes, waiting for room. */
    void receive(int c) throws IOException {
        pipe.write((char) c);
    }

    @Override
    public int read() throws IOException {
        return pipe.read();
    }

    /** Waits for the first char, then reads what is there. */
    @Override
    public int read(char[] cbuf, int off, int len) throws IOException {
        Objects.checkFromIndexSize(off, len, cbuf.length);
        synchronized (pipe) {
            int count = 0;
            while (count < len && (count == 0 || pipe.filled() > 0)) {
                int value = read();
                if (value < 0) {
                    return -1;
                }
                cbuf[off + count] = (char) value;
                count++;
            }
            return count;
        }
    }

    @Override
    public boolean ready() throws IOException {
        return pipe.available() > 0;
    }

    @Override
    public void close() {
        pipe.closeReader();
    }
}
