package programs.failing.runaways;

/**
 * A program that allocates and forgets for ever ends at the time limit.
 *
 * @expected time-limit
 * @limit 1 s
 */
public class EndlessGarbage {
    private static byte[] last;

    public static void main(String[] args) {
        while (true) {
            last = new byte[100_000];
        }
    }
}
