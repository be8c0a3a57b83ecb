package lejos.remote.nxt;

/** Makes connections to other bricks. */
public abstract class NXTCommConnector {
    /** A connector. */
    public NXTCommConnector() {}

    /**
     * Connects to a brick.
     *
     * @param target name or address
     * @param mode one of the modes of {@link NXTConnection}
     * @return the connection, null if it cannot be made
     */
    public abstract NXTConnection connect(String target, int mode);

    /**
     * Waits until another brick connects to this one.
     *
     * @param timeout limit in milliseconds, 0 = none
     * @param mode one of the modes of {@link NXTConnection}
     * @return the connection, null after the time limit or {@link #cancel}
     */
    public abstract NXTConnection waitForConnection(int timeout, int mode);

    /**
     * Ends a wait on another thread.
     *
     * @return whether there was one
     */
    public abstract boolean cancel();
}
