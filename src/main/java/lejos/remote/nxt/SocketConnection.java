package lejos.remote.nxt;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.Socket;
import java.net.SocketTimeoutException;
import lejos.utility.Delay;

/**
 * A connection over a network socket. It waits for bytes in short naps, so that the clock of a simulation goes on.
 *
 * <p>One thread may read while another writes.
 */
public class SocketConnection extends NXTConnection {
    private static final int POLL_MILLIS = 1;
    private static final int NAP_MILLIS = 10;

    private final Socket socket;

    /** A connection over a connected socket, which it closes. */
    public SocketConnection(Socket socket) {
        this.socket = socket;
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }

    @Override
    public int read(byte[] buf, int length) {
        return read(buf, length, true);
    }

    @Override
    public int write(byte[] data, int len) {
        try {
            OutputStream out = socket.getOutputStream();
            out.write(data, 0, len);
            out.flush();
            return len;
        } catch (IOException e) {
            return -1;
        }
    }

    @Override
    public int read(byte[] data, int len, boolean wait) {
        try {
            socket.setSoTimeout(POLL_MILLIS);
            InputStream in = socket.getInputStream();
            int count = poll(in, data, len);
            while (count == 0 && wait && len > 0) {
                Delay.msDelay(NAP_MILLIS);
                count = poll(in, data, len);
            }
            return count;
        } catch (IOException e) {
            return -1;
        }
    }

    /** Reads what there is: 0 bytes if none, negative at the end. */
    private static int poll(InputStream in, byte[] data, int len) throws IOException {
        try {
            return in.read(data, 0, len);
        } catch (SocketTimeoutException e) {
            return 0;
        }
    }
}
