package programs.passing.monitors;

/**
 * A synchronized block keeps others out, however long its owner sleeps, and can be entered again by its owner.
 *
 * @expected exited 0
 * @prints a enters
 * @prints a leaves
 * @prints b enters
 * @prints b leaves
 */
public class SynchronizedBlocks {
    private static final Object LOCK = new Object();

    public static void main(String[] args) throws InterruptedException {
        Thread a = new Thread(() -> visit("a"));
        Thread b = new Thread(() -> visit("b"));
        a.start();
        b.start();
        a.join();
        b.join();
    }

    private static void visit(String name) {
        synchronized (LOCK) {
            System.out.println(name + " enters");
            synchronized (LOCK) {
                try {
                    Thread.sleep(100);
                } catch (InterruptedException e) {
                    return;
                }
            }
            System.out.println(name + " leaves");
        }
    }
}
