package programs.passing.concurrency;

import java.util.Arrays;
import java.util.concurrent.BlockingDeque;
import java.util.concurrent.DelayQueue;
import java.util.concurrent.Delayed;
import java.util.concurrent.LinkedBlockingDeque;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.LinkedTransferQueue;
import java.util.concurrent.PriorityBlockingQueue;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.TimeUnit;

/**
 * One of each kind of blocking queue.
 *
 * @expected exited 0
 * @prints linked [a, b] full false
 * @prints deque c a b
 * @prints priority 1 2 3
 * @prints transfer handed over
 * @prints synchronous x
 * @prints delayed short long
 */
public class Queues {
    private static final class Wait implements Delayed {
        private final String name;
        private final long due;

        Wait(String name, long millis) {
            this.name = name;
            this.due = System.nanoTime() + millis * 1000000;
        }

        @Override
        public long getDelay(TimeUnit unit) {
            return unit.convert(due - System.nanoTime(), TimeUnit.NANOSECONDS);
        }

        @Override
        public int compareTo(Delayed other) {
            return Long.signum(due - ((Wait) other).due);
        }
    }

    /** The program. */
    public static void main(String[] args) throws Exception {
        LinkedBlockingQueue<String> linked = new LinkedBlockingQueue<>(2);
        linked.add("a");
        linked.add("b");
        System.out.println("linked " + linked + " full " + linked.offer("c"));
        BlockingDeque<String> deque = new LinkedBlockingDeque<>(Arrays.asList("a", "b"));
        deque.putFirst("c");
        System.out.println("deque " + deque.takeFirst() + " " + deque.takeFirst() + " " + deque.takeLast());
        PriorityBlockingQueue<Integer> priority = new PriorityBlockingQueue<>(Arrays.asList(3, 1, 2));
        System.out.println("priority " + priority.take() + " " + priority.take() + " " + priority.take());
        LinkedTransferQueue<String> transfer = new LinkedTransferQueue<>();
        Thread taker = new Thread(() -> {
            try {
                transfer.take();
            } catch (InterruptedException e) {
                System.out.println("interrupted");
            }
        });
        taker.start();
        transfer.transfer("t");
        System.out.println("transfer handed over");
        SynchronousQueue<String> synchronous = new SynchronousQueue<>();
        Thread giver = new Thread(() -> {
            try {
                synchronous.put("x");
            } catch (InterruptedException e) {
                System.out.println("interrupted");
            }
        });
        giver.start();
        System.out.println("synchronous " + synchronous.take());
        DelayQueue<Wait> delayed = new DelayQueue<>();
        Wait brief = new Wait("short", 20);
        delayed.put(new Wait("long", 60));
        delayed.put(brief);
        System.out.println("delayed " + delayed.take().name + " " + delayed.take().name);
    }
}
