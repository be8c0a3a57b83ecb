package lejos.hardware;

/** A device cannot be used: its port is taken, it does not answer, or it was unplugged. */
public class DeviceException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    /** An exception without a message. */
    public DeviceException() {}

    /** An exception with a message. */
    public DeviceException(String message) {
        super(message);
    }

    /** An exception caused by another one. */
    public DeviceException(Throwable cause) {
        super(cause);
    }

    /** An exception with a message, caused by another one. */
    public DeviceException(String message, Throwable cause) {
        super(message, cause);
    }
}
