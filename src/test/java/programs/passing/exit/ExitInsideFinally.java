package programs.passing.exit;

/**
 * System.exit works in a finally block, in a handler and with a monitor held.
 *
 * @expected exited 6
 * @prints handler
 */
public class ExitInsideFinally {
    public static void main(String[] args) {
        synchronized (args) {
            try {
                throw new IllegalStateException();
            } catch (IllegalStateException e) {
                System.out.println("handler");
            } finally {
                System.exit(6);
            }
        }
    }
}
