package programs.failing.uncaught;

/**
 * An exception in the static initialiser of the main class fails the program.
 *
 * @expected failed java.lang.ExceptionInInitializerError
 * @contains Caused by: java.lang.IllegalStateException: no motor
 * @contains at programs.failing.uncaught.BrokenInitialiser.<clinit>(BrokenInitialiser.java:
 */
public class BrokenInitialiser {
    private static final int SPEED = speed();

    private static int speed() {
        throw new IllegalStateException("no motor");
    }

    public static void main(String[] args) {
        System.out.println(SPEED);
    }
}
