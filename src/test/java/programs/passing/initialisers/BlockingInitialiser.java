package programs.passing.initialisers;

/**
 * A static initialiser may sleep while other threads run.
 *
 * @expected exited 0
 * @prints initialiser begins
 * @prints other thread at 100 ms
 * @prints initialiser ends
 * @prints value 42
 */
public class BlockingInitialiser {
    static final class Slow {
        static final int VALUE;

        static {
            System.out.println("initialiser begins");
            try {
                Thread.sleep(300);
            } catch (InterruptedException e) {
                throw new IllegalStateException(e);
            }
            System.out.println("initialiser ends");
            VALUE = 42;
        }
    }

    public static void main(String[] args) {
        long start = System.currentTimeMillis();
        new Thread(() -> {
            try {
                Thread.sleep(100);
            } catch (InterruptedException e) {
                return;
            }
            System.out.println("other thread at " + (System.currentTimeMillis() - start) / 10 * 10 + " ms");
        }).start();
        System.out.println("value " + Slow.VALUE);
    }
}
