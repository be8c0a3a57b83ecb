package programs.failing.runaways;

/**
 * Two threads that spin on flags nobody sets, without a call in the loop, share the processor until the time limit.
 *
 * @expected time-limit
 * @limit 1 s
 * @prints third thread ran
 */
public class SpinsWithoutACall {
    private static volatile boolean never;
    private static boolean plainNever;

    public static void main(String[] args) {
        new Thread(() -> {
            while (!never) {
            }
        }).start();
        new Thread(() -> System.out.println("third thread ran")).start();
        do {
        } while (!plainNever);
    }
}
