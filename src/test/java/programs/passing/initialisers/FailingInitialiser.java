package programs.passing.initialisers;

/**
 * An exception in a static initialiser is wrapped once; later uses of the class are refused.
 *
 * @expected exited 0
 * @prints java.lang.ExceptionInInitializerError caused by java.lang.IllegalStateException: no sensor
 * @prints java.lang.NoClassDefFoundError
 */
public class FailingInitialiser {
    static class Broken {
        static int value = compute();

        static int compute() {
            throw new IllegalStateException("no sensor");
        }
    }

    public static void main(String[] args) {
        try {
            Broken.value++;
        } catch (ExceptionInInitializerError e) {
            System.out.println(e.getClass().getName() + " caused by " + e.getCause());
        }
        try {
            new Broken();
        } catch (NoClassDefFoundError e) {
            System.out.println(e.getClass().getName());
        }
    }
}
