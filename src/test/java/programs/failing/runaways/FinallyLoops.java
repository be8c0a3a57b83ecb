package programs.failing.runaways;

/**
 * An endless loop in a finally block, in a synchronized block and in a handler ends at the time limit.
 *
 * @expected time-limit
 * @limit 5 s
 */
public class FinallyLoops {
    public static void main(String[] args) {
        for (int i = 0; i < 3; i++) {
            new Thread(FinallyLoops::spoil).start();
        }
        spoil();
    }

    private static void spoil() {
        try {
            synchronized (FinallyLoops.class) {
                FinallyLoops.class.wait(10);
                throw new IllegalStateException();
            }
        } catch (InterruptedException | RuntimeException e) {
            while (true) {
                try {
                    Thread.yield();
                } finally {
                    try {
                        spin(10);
                    } catch (Error error) {
                        spin(20);
                    }
                }
            }
        } finally {
            while (true) {
                spin(1);
            }
        }
    }

    private static synchronized void spin(int count) {
        for (int i = 0; i < count; i++) {
            Math.sqrt(i);
        }
    }
}
