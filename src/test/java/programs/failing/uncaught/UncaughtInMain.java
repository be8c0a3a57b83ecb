package programs.failing.uncaught;

/**
 * An uncaught exception in the main thread fails the program.
 *
 * @expected failed java.lang.ArrayIndexOutOfBoundsException
 * @contains Exception in thread "main" java.lang.ArrayIndexOutOfBoundsException: Index 3 out of bounds for length 3
 * @contains 	at programs.failing.uncaught.UncaughtInMain.main(UncaughtInMain.java:
 */
public class UncaughtInMain {
    public static void main(String[] args) {
        int[] values = new int[3];
        for (int i = 0; i <= values.length; i++) {
            values[i] = i;
        }
    }
}
