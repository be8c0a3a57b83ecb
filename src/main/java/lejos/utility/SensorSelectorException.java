package lejos.utility;

/** There is no driver for the plugged sensor. */
public class SensorSelectorException extends Exception {
    private static final long serialVersionUID = 1L;

    /** With an explanation. */
    public SensorSelectorException(String message) {
        super(message);
    }
}
