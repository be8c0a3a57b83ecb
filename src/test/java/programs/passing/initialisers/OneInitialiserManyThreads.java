package programs.passing.initialisers;

/**
 * Threads that use a class while it is initialised wait for it; the initialiser runs once.
 *
 * @expected exited 0
 * @prints initialised
 * @prints a sees 1
 * @prints b sees 1
 * @prints c sees 1
 */
public class OneInitialiserManyThreads {
    static final class Shared {
        static int count;

        static {
            pause();
            count++;
            System.out.println("initialised");
        }

        static void pause() {
            try {
                Thread.sleep(50);
            } catch (InterruptedException e) {
                throw new IllegalStateException(e);
            }
        }
    }

    public static void main(String[] args) {
        for (String name : new String[] {"a", "b", "c"}) {
            new Thread(() -> System.out.println(name + " sees " + Shared.count)).start();
        }
    }
}
