package brickless.concurrent.io;

import java.io.IOException;

/** What a writer knows of its pipe: the reader {@code R} at the other end, once it is connected. */
final class WritingEnd<R> {
    private volatile R reader;
    private Pipe pipe;

    /** Connects both ends; IOException if either is connected. */
    synchronized void connect(R reader, Pipe pipe) throws IOException {
        if (this.reader != null) {
            throw new IOException("Already connected");
        }
        pipe.connect();
        this.pipe = pipe;
        this.reader = reader;
    }

    /** The other end; IOException if there is none. */
    R reader() throws IOException {
        if (reader == null) {
            throw new IOException("Pipe not connected");
        }
        return reader;
    }

    /** Tells the reader to look. */
    void flush() {
        if (reader != null) {
            pipe.flush();
        }
    }

    /** No more will be written. */
    void close() {
        if (reader != null) {
            pipe.closeWriter();
        }
    }
}
