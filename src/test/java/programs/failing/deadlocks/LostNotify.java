package programs.failing.deadlocks;

/**
 * A notify that comes before the wait is lost; the program hangs and is reported as deadlocked, with thread, lock and
 * line.
 *
 * @expected deadlock
 * @contains "late" WAITING on java.lang.Object at LostNotify.java:29
 */
public class LostNotify {
    public static void main(String[] args) {
        Object lock = new Object();
        Thread late = new Thread(() -> {
            try {
                Thread.sleep(100);
                listen(lock);
            } catch (InterruptedException e) {
                return;
            }
        }, "late");
        late.start();
        synchronized (lock) {
            lock.notify();
        }
    }

    private static void listen(Object lock) throws InterruptedException {
        synchronized (lock) {
            lock.wait();
        }
    }
}
