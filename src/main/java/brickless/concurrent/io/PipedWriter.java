package brickless.concurrent.io;

import java.io.IOException;
import java.io.Writer;
import java.util.Objects;

/** {@code java.io.PipedWriter} on virtual monitors. */
public class PipedWriter extends Writer {
    private final WritingEnd<PipedReader> end = new WritingEnd<>();

    /** Creates a stream that writes to {@code snk}. */
    public PipedWriter(PipedReader snk) throws IOException {
        connect(snk);
    }

    /** Creates a stream that is not connected yet. */
    public PipedWriter() {
    }

    /** Connects both ends; IOException if either is connected. */
    public void connect(PipedReader snk) throws IOException {
        end.connect(snk, snk.pipe());
    }

    /** Waits for room. */
    @Override
    public void write(int c) throws IOException {
        end.reader().receive(c);
    }

    /** Waits for room. */
    @Override
    public void write(char[] cbuf, int off, int len) throws IOException {
        PipedReader target = end.reader();
        Objects.checkFromIndexSize(off, len, cbuf.length);
        for (int i = off; i < off + len; i++) {
            target.receive(cbuf[i]);
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
