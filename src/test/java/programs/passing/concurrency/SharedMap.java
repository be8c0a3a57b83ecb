package programs.passing.concurrency;

import java.util.concurrent.ConcurrentHashMap;

/**
 * Two threads count in one map; the function that computes a value takes its time.
 *
 * @expected exited 0
 * @prints made count
 * @prints 200
 */
public class SharedMap {
    private static final ConcurrentHashMap<String, Integer> COUNTS = new ConcurrentHashMap<>();

    /** The program. */
    public static void main(String[] args) throws Exception {
        Thread left = new Thread(SharedMap::count);
        Thread right = new Thread(SharedMap::count);
        left.start();
        right.start();
        left.join();
        right.join();
        System.out.println(COUNTS.get("count"));
    }

    private static void count() {
        COUNTS.computeIfAbsent("count", key -> {
            pause(20);
            System.out.println("made " + key);
            return 0;
        });
        for (int i = 0; i < 100; i++) {
            COUNTS.merge("count", 1, (old, one) -> {
                pause(old % 50 == 0 ? 5 : 0);
                return old + one;
            });
        }
    }

    private static void pause(long millis) {
        try {
            Thread.sleep(millis);
        } catch (InterruptedException e) {
            System.out.println("interrupted");
        }
    }
}
