package programs.passing.monitors;

/**
 * Synchronized methods, of objects and of classes, lock what the language says and unlock when they throw.
 *
 * @expected exited 0
 * @prints instance locked: true, class locked: false
 * @prints instance locked: false, class locked: true
 * @prints thrown, instance locked: false
 * @prints total 2000
 */
public class SynchronizedMethods {
    private int total;

    private synchronized void instance() {
        show();
    }

    private static synchronized void type() {
        new SynchronizedMethods().show();
    }

    private void show() {
        System.out.println("instance locked: " + Thread.holdsLock(this) + ", class locked: "
                + Thread.holdsLock(SynchronizedMethods.class));
    }

    private synchronized int fail(long wide, double alsoWide) {
        if (wide > alsoWide) {
            throw new IllegalArgumentException();
        }
        return 0;
    }

    private synchronized void add(int amount) {
        int read = total;
        Thread.yield();
        total = read + amount;
    }

    public static void main(String[] args) throws InterruptedException {
        SynchronizedMethods program = new SynchronizedMethods();
        program.instance();
        type();
        try {
            program.fail(2, 1);
        } catch (IllegalArgumentException e) {
            System.out.println("thrown, instance locked: " + Thread.holdsLock(program));
        }
        Runnable adding = () -> {
            for (int i = 0; i < 1000; i++) {
                program.add(1);
            }
        };
        Thread other = new Thread(adding);
        other.start();
        adding.run();
        other.join();
        System.out.println("total " + program.total);
    }
}
