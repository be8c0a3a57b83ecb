package programs.failing.deadlocks;

/**
 * Two threads take two locks in opposite order: round-robin never meets the deadlock, random schedules do.
 *
 * @expected exited 0
 * @explore 200 deadlock
 */
public class LockOrder {
    private static final Object LEFT = new Object();
    private static final Object RIGHT = new Object();

    public static void main(String[] args) {
        new Thread(() -> both(LEFT, RIGHT), "left").start();
        new Thread(() -> both(RIGHT, LEFT), "right").start();
    }

    private static void both(Object first, Object second) {
        for (int i = 0; i < 20; i++) {
            synchronized (first) {
                synchronized (second) {
                    Math.sqrt(i);
                }
            }
        }
    }
}
