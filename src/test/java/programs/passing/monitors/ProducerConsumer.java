package programs.passing.monitors;

import java.util.LinkedList;

/**
 * A producer and two consumers share a bounded buffer.
 *
 * @expected exited 0
 * @prints consumed 60, sum 1770
 */
public class ProducerConsumer {
    private final LinkedList<Integer> buffer = new LinkedList<>();
    private int consumed;
    private int sum;

    private synchronized void put(int value) throws InterruptedException {
        while (buffer.size() == 3) {
            wait();
        }
        buffer.add(value);
        notifyAll();
    }

    private synchronized boolean take() throws InterruptedException {
        while (buffer.isEmpty() && consumed < 60) {
            wait();
        }
        if (consumed == 60) {
            return false;
        }
        sum += buffer.removeFirst();
        consumed++;
        notifyAll();
        return true;
    }

    private void consume() {
        try {
            while (take()) {
                Thread.sleep(2);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    public static void main(String[] args) throws InterruptedException {
        ProducerConsumer shop = new ProducerConsumer();
        Thread first = new Thread(shop::consume);
        Thread second = new Thread(shop::consume);
        first.start();
        second.start();
        for (int i = 0; i < 60; i++) {
            shop.put(i);
        }
        first.join();
        second.join();
        System.out.println("consumed " + shop.consumed + ", sum " + shop.sum);
    }
}
