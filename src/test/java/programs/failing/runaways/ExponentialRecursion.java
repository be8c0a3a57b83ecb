package programs.failing.runaways;

/**
 * Recursion without a loop that would take years ends at the time limit: calls take time.
 *
 * @expected time-limit
 * @limit 1 s
 */
public class ExponentialRecursion {
    public static void main(String[] args) {
        System.out.println(fibonacci(90));
    }

    private static long fibonacci(int n) {
        return n < 2 ? n : fibonacci(n - 1) + fibonacci(n - 2);
    }
}
