package programs.passing.threads;

import java.util.concurrent.TimeUnit;

/**
 * Every way to let time pass takes exactly that time.
 *
 * @expected exited 0
 * @prints sleep 1500 ms
 * @prints sleep with nanoseconds 20 ms
 * @prints TimeUnit 2000 ms
 * @prints join for a while 40 ms
 * @prints reference 30 ms
 */
public class WaysToSleep {
    private interface Pause {
        void run() throws InterruptedException;
    }

    private interface Sleeping {
        void forMillis(long millis) throws InterruptedException;
    }

    public static void main(String[] args) throws InterruptedException {
        time("sleep", () -> Thread.sleep(1500));
        time("sleep with nanoseconds", () -> Thread.sleep(19, 999_999));
        time("TimeUnit", () -> TimeUnit.SECONDS.sleep(2));
        time("join for a while", () -> Thread.currentThread().join(40));
        Sleeping reference = Thread::sleep;
        time("reference", () -> reference.forMillis(30));
    }

    private static void time(String what, Pause pause) throws InterruptedException {
        long start = System.nanoTime();
        pause.run();
        long tenths = (System.nanoTime() - start + 50_000) / 100_000;
        System.out.println(what + " " + tenths / 10 + " ms");
    }
}
