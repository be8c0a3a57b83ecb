package programs.failing.runaways;

/**
 * A shutdown hook that never ends runs into the time limit.
 *
 * @expected time-limit
 * @limit 1 s
 * @prints bye
 */
public class EndlessShutdownHook {
    private static volatile int rounds;

    public static void main(String[] args) {
        Runtime.getRuntime().addShutdownHook(new Thread(() -> {
            System.out.println("bye");
            while (true) {
                rounds++;
            }
        }));
    }
}
