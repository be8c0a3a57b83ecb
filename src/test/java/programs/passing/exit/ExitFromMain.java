package programs.passing.exit;

/**
 * System.exit ends the program at once, whatever other threads do.
 *
 * @expected exited 3
 * @prints leaving
 */
public class ExitFromMain {
    public static void main(String[] args) {
        new Thread(() -> {
            while (true) {
                Thread.yield();
            }
        }).start();
        System.out.println("leaving");
        System.exit(3);
        System.out.println("unreachable");
    }
}
