package lejos.robotics;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;

/** An object that can be sent to another computer and rebuilt there. */
public interface Transmittable {
    /** Writes the state and flushes. */
    void dumpObject(DataOutputStream dos) throws IOException;

    /** Replaces the state by one that {@link #dumpObject} wrote. */
    void loadObject(DataInputStream dis) throws IOException;
}
