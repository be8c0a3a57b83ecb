package programs.passing.exit;

/**
 * System.exit runs no finally block and no handler, not even one for Throwable.
 *
 * @expected exited 5
 * @prints trying
 */
public class ExitInsideTry {
    public static void main(String[] args) {
        while (true) {
            try {
                System.out.println("trying");
                System.exit(5);
            } catch (Throwable t) {
                System.out.println("caught " + t);
            } finally {
                System.out.println("finally");
            }
        }
    }
}
