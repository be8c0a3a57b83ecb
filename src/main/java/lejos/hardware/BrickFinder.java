package lejos.hardware;

import lejos.hardware.ev3.LocalEV3;
import lejos.utility.Delay;

/** Finds the brick a program runs on. A virtual brick is on no network: searches take their time and find nothing. */
public class BrickFinder {
    private static final int SEARCH_MILLIS = 2000;
    private static final int BLUETOOTH_INQUIRY_MILLIS = 10_000;

    private static Brick defaultBrick;

    /** Creates an object nobody needs: all methods are static. */
    public BrickFinder() {}

    /** The brick the program runs on. */
    public static Brick getLocal() {
        return LocalEV3.get();
    }

    /** The brick set with {@link #setDefault}, else the one the program runs on. */
    public static synchronized Brick getDefault() {
        if (defaultBrick == null) {
            defaultBrick = LocalEV3.get();
        }
        return defaultBrick;
    }

    /**
     * Searches the network for bricks of that name; blocks for 2 s.
     *
     * @return the bricks found: none
     */
    public static BrickInfo[] find(String name) {
        Delay.msDelay(SEARCH_MILLIS);
        return new BrickInfo[0];
    }

    /** Searches the network for any bricks; blocks for 2 s. */
    public static BrickInfo[] discover() {
        return find("*");
    }

    /** Searches for NXT bricks by Bluetooth; blocks for 10 s. */
    public static BrickInfo[] discoverNXT() {
        Delay.msDelay(BLUETOOTH_INQUIRY_MILLIS);
        return new BrickInfo[0];
    }

    /**
     * Sets the brick that {@link #getDefault()} returns; classes such as {@code Button} keep the one they have met
     * first.
     */
    public static synchronized void setDefault(Brick brick) {
        defaultBrick = brick;
    }

    /** Accepted without effect: no other brick could ask for this one. */
    public static void startDiscoveryServer(boolean forwardNameRequests) {
        // A virtual brick is on no network.
    }

    /** Accepted without effect: no other brick could ask for this one. */
    public static void stopDiscoveryServer() {
        // A virtual brick is on no network.
    }
}
