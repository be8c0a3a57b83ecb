package lejos.hardware;

/** A Bluetooth operation failed. */
public class BluetoothException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    /** Without explanation. */
    public BluetoothException() {}

    /** With an explanation. */
    public BluetoothException(String message) {
        super(message);
    }

    /** With a cause. */
    public BluetoothException(Throwable cause) {
        super(cause);
    }

    /** With an explanation and a cause. */
    public BluetoothException(String message, Throwable cause) {
        super(message, cause);
    }
}
