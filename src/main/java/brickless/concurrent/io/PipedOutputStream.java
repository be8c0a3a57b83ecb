package brickless.concurrent.io;

import java.io.IOException;
import java.io.OutputStream;
import java.util.Objects;

/** {@code java.io.PipedOutputStream} on virtual monitors. */
public class PipedOutputStream extends OutputStream {
    private final WritingEnd<PipedInputStream> end = new WritingEnd<>();

    /** Creates a stream that writes to {@code snk}. */
    public PipedOutputStream(PipedInputStream snk) throws IOException {
        connect(snk);
    }

    /** Creates a stream that is not connected yet. */
    public PipedOutputStream() {
    }

    /** Connects both ends; IOException if either is connected. */
    public void connect(PipedInputStream snk) throws IOException {
        end.connect(snk, snk.pipe());
    }

    /** Waits for room. */
    @Override
    public void write(int b) throws IOException {
        end.reader().receive(b);
    }

    /** Waits for room. */
    @Override
    public void write(byte[] b, int off, int len) throws IOException {
        PipedInputStream target = end.reader();
        Objects.checkFromIndexSize(off, len, b.length);
        for (int i = off; i < off + len; i++) {
            target.receive(b[i]);
        }
    }

    @Override
    public void flush() throws IOException {
        end.flush();
    }

    @Override
    public void close() throws IOException {
        end.close();
    }
}
