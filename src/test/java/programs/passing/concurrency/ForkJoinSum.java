package programs.passing.concurrency;

import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ForkJoinTask;
import java.util.concurrent.RecursiveTask;

/**
 * A recursive task splits a sum.
 *
 * @expected exited 0
 * @prints sum 5050
 * @prints inside true
 */
public class ForkJoinSum {
    private static final class Sum extends RecursiveTask<Integer> {
        private static final long serialVersionUID = 1L;

        private final int from;
        private final int to;

        Sum(int from, int to) {
            this.from = from;
            this.to = to;
        }

        @Override
        protected Integer compute() {
            if (from == to) {
                return from;
            }
            int middle = (from + to) / 2;
            Sum left = new Sum(from, middle);
            left.fork();
            return new Sum(middle + 1, to).compute() + left.join();
        }
    }

    /** The program. */
    public static void main(String[] args) throws Exception {
        ForkJoinPool pool = new ForkJoinPool(2);
        System.out.println("sum " + pool.invoke(new Sum(1, 100)));
        System.out.println("inside " + pool.submit(() -> ForkJoinTask.inForkJoinPool()).get());
        pool.shutdown();
    }
}
