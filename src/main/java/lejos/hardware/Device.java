package lejos.hardware;

import java.io.Closeable;
import java.io.IOException;
import java.util.ArrayList;

/** Anything plugged into the brick; owns what must be released when it is closed. */
public class Device implements Closeable {
    /** What {@link #close()} releases, in the order registered. */
    protected ArrayList<Closeable> closeList = new ArrayList<>();

    /** A device that owns nothing yet. */
    public Device() {}

    /** Registers something, usually the port that this object opened itself, to be closed with the device. */
    protected void releaseOnClose(Closeable resource) {
        closeList.add(resource);
    }

    /**
     * Releases everything registered. May be called again.
     *
     * @throws DeviceException if one of the resources cannot be closed
     */
    @Override
    public void close() {
        for (Closeable resource : closeList) {
            try {
                resource.close();
            } catch (IOException e) {
                throw new DeviceException("Error during close", e);
            }
        }
    }
}
