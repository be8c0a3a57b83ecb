package brickless.concurrent.io;

import java.io.IOException;
import java.io.Writer;
import java.util.Objects;

/** {@code java.io.PipedWriter} on virtual monitors. */
public class PipedWriter extends Writer {
    private volatile PipedReader sink;

    /** Creates a stream that writes to {@code snk}. */
    public PipedWriter(PipedReader snk) throws IOException {
        connect(snk);
    }

    /** Creates a stream that is not connected yet. */
    public PipedWriter() {
    }

    /** Connects both ends; IOException if either is connected. */
    public synchronized void connect(PipedReader snk) throws IOException {
        if (sink != null) {
            throw new IOException("Already connected");
        }
        snk.pipe().connect();
        sink = snk;
    }

    private PipedReader sink() throws IOException {
        if (sink == null) {
            throw new IOException("Pipe not connected");
        }
        return sink;
    }

    /** Waits for room. */
    @Override
    public void write(int c) throws IOException {
        sink().receive(c);
    }

    /** Waits for room. */
    @Override
    public void write(char[] cbuf, int off, int len) throws IOException {
        PipedReader target = sink();
        Objects.checkFromIndexSize(off, len, cbuf.length);
        for (int i = off; i < off + len; i++) {
            target.receive(cbuf[i]);
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
