package programs.passing.concurrency;

import java.util.Timer;
import java.util.TimerTask;
import java.util.concurrent.CountDownLatch;

/**
 * A timer ticks three times and is cancelled by its own task.
 *
 * @expected exited 0
 * @prints tick 1 on beat
 * @prints tick 2 on beat
 * @prints tick 3 on beat
 * @prints already cancelled
 */
public class TimerTicks {
    /** The program. */
    public static void main(String[] args) throws Exception {
        Timer timer = new Timer("beat");
        CountDownLatch done = new CountDownLatch(3);
        timer.scheduleAtFixedRate(new TimerTask() {
            private int ticks;

            @Override
            public void run() {
                ticks++;
                System.out.println("tick " + ticks + " on " + Thread.currentThread().getName());
                if (ticks == 3) {
                    timer.cancel();
                }
                done.countDown();
            }
        }, 10, 20);
        done.await();
        try {
            timer.schedule(new TimerTask() {
                @Override
                public void run() {
                    System.out.println("never");
                }
            }, 0);
        } catch (IllegalStateException e) {
            System.out.println("already cancelled");
        }
    }
}
