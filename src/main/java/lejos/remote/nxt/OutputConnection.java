package lejos.remote.nxt;

import java.io.DataOutputStream;
import java.io.OutputStream;

/** A connection to write to. */
public interface OutputConnection extends Connection {
    /** A data stream to write to. */
    DataOutputStream openDataOutputStream();

    /** A stream to write to. */
    OutputStream openOutputStream();
}
