package lejos.hardware.port;

/** A transaction on an I²C bus failed. */
public class I2CException extends PortException {
    private static final long serialVersionUID = 1L;

    /** An exception without a message. */
    public I2CException() {}

    /** An exception with a message. */
    public I2CException(String message) {
        super(message);
    }

    /** An exception caused by another one. */
    public I2CException(Throwable cause) {
        super(cause);
    }

    /** An exception with a message, caused by another one. */
    public I2CException(String message, Throwable cause) {
        super(message, cause);
    }
}
