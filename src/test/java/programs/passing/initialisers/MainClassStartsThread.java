package programs.passing.initialisers;

/**
 * The static initialiser of the main class may start a thread that uses the class, and wait a while for it.
 *
 * @expected exited 0
 * @prints initialiser ends
 * @prints main
 * @prints worker sees 5
 */
public class MainClassStartsThread {
    private static int value;

    static {
        Thread worker = new Thread(() -> System.out.println("worker sees " + value()));
        worker.start();
        try {
            worker.join(200);
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
        value = 5;
        System.out.println("initialiser ends");
    }

    static int value() {
        return new Reader().value;
    }

    /** Uses the main class from another one, which has to wait for the initialiser. */
    static final class Reader {
        final int value = MainClassStartsThread.value;
    }

    public static void main(String[] args) {
        System.out.println("main");
    }
}
