package programs.passing.initialisers;

/**
 * A static initialiser that only computes is not interrupted by other threads, which use the class too.
 *
 * @expected exited 0
 * @prints 2000
 * @schedules 40
 */
public class TablesInTurns {
    static final class Table {
        static final int[] VALUES = new int[1000];

        static {
            for (int i = 0; i < VALUES.length; i++) {
                VALUES[i] = Math.max(1, i - 1000);
            }
        }
    }

    private static int sum;

    static synchronized void add() {
        for (int value : Table.VALUES) {
            sum += value;
        }
    }

    public static void main(String[] args) throws InterruptedException {
        Thread first = new Thread(() -> {
            int begin = Table.VALUES[0];
            add();
        });
        Thread second = new Thread(() -> {
            int begin = Table.VALUES[0];
            add();
        });
        first.start();
        second.start();
        first.join();
        second.join();
        System.out.println(sum);
    }
}
