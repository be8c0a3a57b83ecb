package programs.passing.concurrency;

import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;

/**
 * Delayed tasks run by due time, not by order of submission; a cancelled one does not run.
 *
 * @expected exited 0
 * @prints first
 * @prints second
 * @prints third
 * @prints result 42
 */
public class DelayedTasks {
    /** The program. */
    public static void main(String[] args) throws Exception {
        ScheduledExecutorService scheduler = Executors.newSingleThreadScheduledExecutor();
        scheduler.schedule(() -> System.out.println("third"), 90, TimeUnit.MILLISECONDS);
        scheduler.schedule(() -> System.out.println("first"), 30, TimeUnit.MILLISECONDS);
        ScheduledFuture<?> never = scheduler.schedule(() -> System.out.println("never"), 50, TimeUnit.MILLISECONDS);
        scheduler.schedule(() -> System.out.println("second"), 60, TimeUnit.MILLISECONDS);
        never.cancel(false);
        ScheduledFuture<Integer> last = scheduler.schedule(() -> 42, 120, TimeUnit.MILLISECONDS);
        System.out.println("result " + last.get());
        scheduler.shutdown();
    }
}
