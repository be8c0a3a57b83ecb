package programs.failing.deadlocks;

/**
 * Two threads that sleep between two locks, taken in opposite order, deadlock in every schedule; a third one goes on.
 *
 * @expected deadlock
 * @contains "left" BLOCKED on java.lang.Integer
 * @contains held by "right"
 */
public class LockOrderAsleep {
    private static final Object LEFT = 1;
    private static final Object RIGHT = 2;

    public static void main(String[] args) throws InterruptedException {
        new Thread(() -> both(LEFT, RIGHT), "left").start();
        new Thread(() -> both(RIGHT, LEFT), "right").start();
        Thread.sleep(1_000);
        System.out.println("main goes on");
    }

    private static void both(Object first, Object second) {
        synchronized (first) {
            try {
                Thread.sleep(100);
            } catch (InterruptedException e) {
                return;
            }
            synchronized (second) {
                System.out.println("never");
            }
        }
    }
}
