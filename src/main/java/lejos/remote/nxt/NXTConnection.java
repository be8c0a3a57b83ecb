package lejos.remote.nxt;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;

/** A connection to another brick that transports packets or bytes. */
public abstract class NXTConnection implements StreamConnection {
    /** Mode: LEGO communication protocol. */
    public static final int LCP = 1;
    /** Mode: packets with a length in front. */
    public static final int PACKET = 0;
    /** Mode: plain bytes. */
    public static final int RAW = 2;

    /** An open connection. */
    public NXTConnection() {}

    @Override
    public DataInputStream openDataInputStream() {
        return new DataInputStream(openInputStream());
    }

    @Override
    public InputStream openInputStream() {
        return new ReadingStream();
    }

    @Override
    public abstract void close() throws IOException;

    @Override
    public DataOutputStream openDataOutputStream() {
        return new DataOutputStream(openOutputStream());
    }

    @Override
    public OutputStream openOutputStream() {
        return new WritingStream();
    }

    /**
     * Reads, blocking until something has arrived.
     *
     * @return number of bytes; negative at the end of the connection
     */
    public abstract int read(byte[] buf, int length);

    /**
     * Writes, blocking until everything is taken.
     *
     * @return number of bytes; negative after a failure
     */
    public abstract int write(byte[] data, int len);

    /**
     * Reads.
     *
     * @param wait whether to block until something has arrived
     * @return number of bytes; negative at the end of the connection
     */
    public abstract int read(byte[] data, int len, boolean wait);

    /** Bytes of the connection, one read of the connection per read of the stream. */
    private final class ReadingStream extends InputStream {
        @Override
        public int read() {
            byte[] one = new byte[1];
            return NXTConnection.this.read(one, 1) == 1 ? one[0] & 0xff : -1;
        }

        @Override
        public int read(byte[] target, int offset, int length) {
            byte[] bytes = new byte[length];
            int count = NXTConnection.this.read(bytes, length);
            if (count <= 0) {
                return length == 0 ? 0 : -1;
            }
            System.arraycopy(bytes, 0, target, offset, count);
            return count;
        }
    }

    /** Writes to the connection without a buffer. */
    private final class WritingStream extends OutputStream {
        @Override
        public void write(int value) throws IOException {
            write(new byte[] {(byte) value}, 0, 1);
        }

        @Override
        public void write(byte[] source, int offset, int length) throws IOException {
            byte[] bytes = new byte[length];
            System.arraycopy(source, offset, bytes, 0, length);
            if (NXTConnection.this.write(bytes, length) < 0) {
                throw new IOException("connection is closed");
            }
        }
    }
}
