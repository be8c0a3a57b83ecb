package programs.passing.concurrency;

import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;

/**
 * A full queue blocks the producer, an empty one the consumer.
 *
 * @expected exited 0
 * @prints got 1
 * @prints got 2
 * @prints got 3
 * @prints sum 6
 * @prints left 0
 */
public class ProducerAndConsumer {
    /** The program. */
    public static void main(String[] args) throws Exception {
        BlockingQueue<Integer> queue = new ArrayBlockingQueue<>(1);
        Thread producer = new Thread(() -> {
            try {
                for (int i = 1; i <= 3; i++) {
                    queue.put(i);
                }
                queue.put(0);
            } catch (InterruptedException e) {
                System.out.println("interrupted");
            }
        });
        producer.start();
        int sum = 0;
        for (int next = queue.take(); next != 0; next = queue.take()) {
            System.out.println("got " + next);
            sum += next;
        }
        System.out.println("sum " + sum);
        System.out.println("left " + queue.size());
    }
}
