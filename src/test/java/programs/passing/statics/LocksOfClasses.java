package programs.passing.statics;

/**
 * Threads of a robot wait for a lock of a class or of a constant string; robots do not wait for each other.
 *
 * @expected exited 0
 * @prints 0 in 1
 * @prints 20
 * @prints true
 */
public class LocksOfClasses {
    private static final Runnable NOTHING = () -> { };
    private static int inside;
    private static int most;
    private static int count;

    static synchronized void visit() throws InterruptedException {
        inside++;
        most = Math.max(most, inside);
        Thread.sleep((long) (Math.random() * 5));
        count++;
        inside--;
    }

    public static void main(String[] args) throws InterruptedException {
        Thread[] threads = new Thread[4];
        for (int i = 0; i < threads.length; i++) {
            threads[i] = new Thread(() -> {
                for (int turn = 0; turn < 5; turn++) {
                    try {
                        visit();
                    } catch (InterruptedException e) {
                        return;
                    }
                }
            });
            threads[i].start();
        }
        for (Thread thread : threads) {
            thread.join();
        }
        System.out.println(inside + " in " + most);
        System.out.println(count);
        synchronized (NOTHING) {
            synchronized ("constant") {
                Thread.sleep((long) (Math.random() * 50));
                System.out.println(Thread.holdsLock(NOTHING) && Thread.holdsLock("constant"));
            }
        }
    }
}
