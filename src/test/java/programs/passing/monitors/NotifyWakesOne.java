package programs.passing.monitors;

/**
 * notify wakes one waiter, notifyAll the rest.
 *
 * @expected exited 0
 * @prints first woken
 * @prints one so far
 * @prints second woken
 * @prints third woken
 */
public class NotifyWakesOne {
    private static final Object LOCK = new Object();
    private static int woken;

    public static void main(String[] args) throws InterruptedException {
        for (String name : new String[] {"first", "second", "third"}) {
            new Thread(() -> await(name)).start();
            Thread.sleep(1);
        }
        synchronized (LOCK) {
            LOCK.notify();
        }
        Thread.sleep(10);
        synchronized (LOCK) {
            System.out.println(woken == 1 ? "one so far" : "woken " + woken);
            LOCK.notifyAll();
        }
    }

    private static void await(String name) {
        synchronized (LOCK) {
            try {
                LOCK.wait();
            } catch (InterruptedException e) {
                return;
            }
            woken++;
            System.out.println(name + " woken");
        }
    }
}
