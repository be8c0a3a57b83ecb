package programs.failing.deadlocks;

/**
 * Threads that join each other in a circle could still be interrupted; when nobody does, it is a deadlock.
 *
 * @expected deadlock
 * @limit 60 s
 * @contains "first"
 * @contains "second"
 */
public class JoinCycle {
    private static Thread first;
    private static Thread second;

    public static void main(String[] args) {
        first = new Thread(() -> join(second), "first");
        second = new Thread(() -> join(first), "second");
        first.start();
        second.start();
    }

    private static void join(Thread other) {
        try {
            other.join();
        } catch (InterruptedException e) {
            System.out.println("interrupted");
        }
    }
}
