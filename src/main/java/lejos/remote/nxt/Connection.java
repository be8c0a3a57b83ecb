package lejos.remote.nxt;

import java.io.IOException;

/** A connection. */
public interface Connection {
    /**
     * Closes the connection.
     *
     * @throws IOException if that fails
     */
    void close() throws IOException;
}
