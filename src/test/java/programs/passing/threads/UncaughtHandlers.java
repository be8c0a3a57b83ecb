package programs.passing.threads;

/**
 * A thread's own handler comes before the default handler; a program whose handlers take every exception does not fail.
 *
 * @expected exited 0
 * @prints own first: java.lang.IllegalStateException: one
 * @prints default second: java.lang.IllegalStateException: two
 */
public class UncaughtHandlers {
    public static void main(String[] args) throws InterruptedException {
        Thread.setDefaultUncaughtExceptionHandler(
                (thread, failure) -> System.out.println("default " + thread.getName() + ": " + failure));
        Thread first = new Thread(() -> fail("one"), "first");
        first.setUncaughtExceptionHandler((thread, failure) ->
                System.out.println("own " + thread.getName() + ": " + failure));
        Thread second = new Thread(() -> fail("two"), "second");
        first.start();
        first.join();
        second.start();
        second.join();
    }

    private static void fail(String message) {
        throw new IllegalStateException(message);
    }
}
