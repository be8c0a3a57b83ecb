package lejos.hardware.port;

/** An operation on a port failed. */
public class PortException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    /** An exception without a message. */
    public PortException() {}

    /** An exception with a message. */
    public PortException(String message) {
        super(message);
    }

    /** An exception caused by another one. */
    public PortException(Throwable cause) {
        super(cause);
    }

    /** An exception with a message, caused by another one. */
    public PortException(String message, Throwable cause) {
        super(message, cause);
    }
}
