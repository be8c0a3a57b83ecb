package lejos.remote.nxt;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;

/** A Bluetooth connection over a pair of streams. */
public class BTConnection extends NXTConnection {
    private static final int FAILED = -1;

    private final InputStream in;
    private final OutputStream out;

    BTConnection(InputStream in, OutputStream out) {
        this.in = in;
        this.out = out;
    }

    @Override
    public void close() throws IOException {
        in.close();
        out.close();
    }

    @Override
    public int read(byte[] buf, int length) {
        return read(buf, length, true);
    }

    @Override
    public int write(byte[] buffer, int numBytes) {
        try {
            out.write(buffer, 0, numBytes);
            out.flush();
            return numBytes;
        } catch (IOException broken) {
            return FAILED;
        }
    }

    @Override
    public int read(byte[] buf, int length, boolean wait) {
        try {
            int ready = wait ? length : Math.min(length, in.available());
            return ready == 0 ? 0 : in.read(buf, 0, ready);
        } catch (IOException broken) {
            return FAILED;
        }
    }
}
