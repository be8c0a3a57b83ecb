package programs.failing.uncaught;

import java.util.Timer;
import java.util.TimerTask;

/**
 * A timer task that throws kills its timer, not the program.
 *
 * @expected failed java.lang.IllegalStateException
 * @contains Timer already cancelled.
 * @contains main ends
 */
public class TimerTaskThrows {
    public static void main(String[] args) throws InterruptedException {
        Timer timer = new Timer("ticks");
        timer.schedule(task(), 100);
        Thread.sleep(500);
        try {
            timer.schedule(task(), 100);
        } catch (IllegalStateException e) {
            System.out.println(e.getMessage());
        }
        System.out.println("main ends");
    }

    private static TimerTask task() {
        return new TimerTask() {
            @Override
            public void run() {
                throw new IllegalStateException("task");
            }
        };
    }
}
