package lejos.remote.nxt;

import java.io.DataInputStream;
import java.io.InputStream;

/** A connection to read from. */
public interface InputConnection extends Connection {
    /** A data stream to read from. */
    DataInputStream openDataInputStream();

    /** A stream to read from. */
    InputStream openInputStream();
}
