package lejos.robotics.navigation;

/** There is no path to the destination. */
public class DestinationUnreachableException extends Exception {
    private static final long serialVersionUID = 1L;

    /** Without a message. */
    public DestinationUnreachableException() {
    }
}
