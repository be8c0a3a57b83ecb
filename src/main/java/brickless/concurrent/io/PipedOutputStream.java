package brickless.concurrent.io;

import java.io.IOException;
import java.io.OutputStream;
import java.util.Objects;

/** {@code java.io.PipedOutputStream} on virtual monitors. */
public class PipedOutputStream extends OutputStream {
    private volatile PipedInputStream sink;

    /** Creates a stream that writes to {@code snk}. */
    public PipedOutputStream(PipedInputStream snk) throws IOException {
        connect(snk);
    }

    /** Creates a stream that is not connected yet. */
    public PipedOutputStream() {
    }

    /** Connects both ends; IOException if either is connected. */
    public synchronized void connect(PipedInputStream snk) throws IOException {
        if (sink != null) {
            throw new IOException("Already connected");
        }
        snk.pipe().connect();
        sink = snk;
    }

    private PipedInputStream sink() throws IOException {
        if (sink == null) {
            throw new IOException("Pipe not connected");
        }
        return sink;
    }

    /** Waits for room. */
    @Override
    public void write(int b) throws IOException {
        sink().receive(b);
    }

    /** Waits for room. */
    @Override
    public void write(byte[] b, int off, int len) throws IOException {
        PipedInputStream target = sink();
        Objects.checkFromIndexSize(off, len, b.length);
        for (int i = off; i < off + len; i++) {
            target.receive(b[i]);
        }
    }

    @Override
    public void flush() throws IOException {
        if (sink != null) {
            sink.pipe().flush();
        }
    }

    @Override
    public void close() throws IOException {
        if (sink != null) {
            sink.pipe().closeWriter();
        }
    }
}
