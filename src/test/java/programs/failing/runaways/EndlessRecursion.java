package programs.failing.runaways;

/**
 * Endless recursion ends the program with a StackOverflowError.
 *
 * @expected failed java.lang.StackOverflowError
 * @contains at programs.failing.runaways.EndlessRecursion.odd(EndlessRecursion.java
 */
public class EndlessRecursion {
    public static void main(String[] args) {
        even(0);
    }

    private static int even(int n) {
        return odd(n + 1);
    }

    private static int odd(int n) {
        return even(n + 1);
    }
}
