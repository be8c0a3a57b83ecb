package programs.failing.runaways;

/**
 * Recursion that catches its own StackOverflowErrors and tries again ends at the time limit.
 *
 * @expected time-limit
 * @limit 1 s
 */
public class SwallowedRecursion {
    public static void main(String[] args) {
        recurse();
    }

    private static void recurse() {
        try {
            recurse();
        } catch (Throwable t) {
            recurse();
        }
    }
}
