package brickless.concurrent.io;

import brickless.concurrent.locks.Deadline;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.util.concurrent.TimeUnit;

/** A pipe: a ring of bytes or chars, who reads and who writes. Guarded by its own monitor. */
final class Pipe {
    /** How often a blocked thread looks whether the thread at the other end is still alive. */
    private static final long LOOK_MILLIS = 1000;

    private final char[] ring;
    private int start;
    private int filled;
    private boolean connected;
    private boolean writerClosed;
    private boolean readerClosed;
    private Thread reader;
    private Thread writer;

    Pipe(int capacity) {
        if (capacity <= 0) {
            throw new IllegalArgumentException("Pipe Size <= 0");
        }
        ring = new char[capacity];
    }

    synchronized void connect() throws IOException {
        if (connected) {
            throw new IOException("Already connected");
        }
        connected = true;
    }

    /** Waits for a free place and fills it. */
    synchronized void write(char value) throws IOException {
        writer = Thread.currentThread();
        requireOpen();
        while (filled == ring.length) {
            if (reader != null && !reader.isAlive()) {
                throw new IOException("Pipe broken");
            }
            pause();
            requireOpen();
        }
        ring[(start + filled) % ring.length] = value;
        filled++;
        notifyAll();
    }

    private void requireOpen() throws IOException {
        requireConnected();
        if (writerClosed || readerClosed) {
            throw new IOException("Pipe closed");
        }
        if (reader != null && !reader.isAlive()) {
            throw new IOException("Read end dead");
        }
    }

    /** Waits for a filled place and empties it: what was in it, or -1 at the end. */
    synchronized int read() throws IOException {
        reader = Thread.currentThread();
        requireReadable();
        while (filled == 0) {
            if (writerClosed) {
                return -1;
            }
            if (writer != null && !writer.isAlive()) {
                throw new IOException("Write end dead");
            }
            pause();
            requireReadable();
        }
        char value = ring[start];
        start = (start + 1) % ring.length;
        filled--;
        notifyAll();
        return value;
    }

    private void requireReadable() throws IOException {
        requireConnected();
        if (readerClosed) {
            throw new IOException("Pipe closed");
        }
    }

    private void requireConnected() throws IOException {
        if (!connected) {
            throw new IOException("Pipe not connected");
        }
    }

    private void pause() throws IOException {
        try {
            Deadline.after(LOOK_MILLIS, TimeUnit.MILLISECONDS).await(this);
        } catch (InterruptedException e) {
            throw (IOException) new InterruptedIOException().initCause(e);
        }
    }

    /** Whether reading would not block; IOException if the pipe cannot be read. */
    synchronized int available() throws IOException {
        requireReadable();
        return filled;
    }

    /** What is filled, or 0 if the pipe cannot be read. */
    synchronized int filled() {
        return connected && !readerClosed ? filled : 0;
    }

    synchronized void closeWriter() {
        writerClosed = true;
        notifyAll();
    }

    synchronized void closeReader() {
        readerClosed = true;
        filled = 0;
        notifyAll();
    }

    /** Tells the reader to look. */
    synchronized void flush() {
        notifyAll();
    }
}
