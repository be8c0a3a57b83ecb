package programs.failing.runaways;

/**
 * A loop that catches everything, finally blocks included, ends at the time limit.
 *
 * @expected time-limit
 * @limit 5 s
 */
public class SwallowingEverything {
    private static int rounds;

    public static void main(String[] args) {
        while (true) {
            try {
                while (true) {
                    rounds++;
                    Thread.sleep(1);
                }
            } catch (Throwable t) {
                rounds--;
            } finally {
                rounds++;
                continue;
            }
        }
    }
}
