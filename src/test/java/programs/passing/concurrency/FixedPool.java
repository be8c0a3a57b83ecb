package programs.passing.concurrency;

import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;

/**
 * A fixed pool runs tasks in the order in which they came and ends when it is told to.
 *
 * @expected exited 0
 * @prints 1 on thread-1
 * @prints 4 on thread-2
 * @prints sum 5
 * @prints rejected
 * @prints terminated true
 */
public class FixedPool {
    private static Callable<Integer> square(int i) {
        return () -> {
            String name = Thread.currentThread().getName();
            System.out.println(i * i + " on " + name.substring(name.indexOf("thread")));
            return i * i;
        };
    }

    /** The program. */
    public static void main(String[] args) throws Exception {
        ExecutorService pool = Executors.newFixedThreadPool(2);
        int sum = 0;
        for (int i = 1; i <= 2; i++) {
            Future<Integer> square = pool.submit(square(i));
            sum += square.get();
        }
        System.out.println("sum " + sum);
        pool.shutdown();
        try {
            pool.execute(() -> System.out.println("never"));
        } catch (RejectedExecutionException e) {
            System.out.println("rejected");
        }
        System.out.println("terminated " + pool.awaitTermination(10, TimeUnit.SECONDS));
    }
}
