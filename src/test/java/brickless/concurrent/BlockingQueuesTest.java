package brickless.concurrent;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import brickless.concurrent.locks.Waiting;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.BlockingDeque;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.Delayed;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@Timeout(30)
class BlockingQueuesTest {
    private static final int SCRIPTS = 60;
    private static final int STEPS = 80;

    private static final Map<String, Supplier<BlockingQueue<Integer>>> OURS = Map.of(
            "array", () -> new ArrayBlockingQueue<>(3, true),
            "linked", () -> new LinkedBlockingQueue<>(3),
            "unlimited", LinkedBlockingQueue::new,
            "deque", () -> new LinkedBlockingDeque<>(3),
            "priority", PriorityBlockingQueue::new,
            "transfer", LinkedTransferQueue::new,
            "synchronous", SynchronousQueue::new);
    private static final Map<String, Supplier<BlockingQueue<Integer>>> JDKS = Map.of(
            "array", () -> new java.util.concurrent.ArrayBlockingQueue<>(3, true),
            "linked", () -> new java.util.concurrent.LinkedBlockingQueue<>(3),
            "unlimited", java.util.concurrent.LinkedBlockingQueue::new,
            "deque", () -> new java.util.concurrent.LinkedBlockingDeque<>(3),
            "priority", java.util.concurrent.PriorityBlockingQueue::new,
            "transfer", java.util.concurrent.LinkedTransferQueue::new,
            "synchronous", java.util.concurrent.SynchronousQueue::new);

    /** What a step returned or threw, and how the queue looks then. */
    private static String step(BlockingQueue<Integer> queue, int choice, int value) {
        Object result;
        try {
            result = apply(queue, choice, value);
        } catch (Exception e) {
            result = e.getClass();
        }
        return result + " " + queue + " size " + queue.size() + " room " + queue.remainingCapacity() + " head "
                + queue.peek();
    }

    private static Object apply(BlockingQueue<Integer> queue, int choice, int value) throws InterruptedException {
        switch (choice) {
            case 0:
                return queue.add(value);
            case 1:
            case 2:
                return queue.offer(value);
            case 3:
                return queue.offer(value, 0, TimeUnit.SECONDS);
            case 4:
                return queue.poll();
            case 5:
                return queue.poll(0, TimeUnit.SECONDS);
            case 6:
                return queue.remove();
            case 7:
                return queue.remove(Integer.valueOf(value));
            case 8:
                return queue.contains(value);
            case 9:
                List<Integer> drained = new ArrayList<>();
                return queue.drainTo(drained, 2) + " " + drained;
            case 10:
                return queue.removeIf(element -> element == value);
            case 11:
                Iterator<Integer> elements = queue.iterator();
                if (elements.hasNext()) {
                    elements.next();
                    elements.remove();
                }
                return List.of(queue.toArray(new Integer[0]));
            case 12:
                return queue.element();
            case 13:
                return queue.add(null);
            case 14:
                return queue.drainTo(queue);
            default:
                return queue.addAll(List.of(value, value + 1));
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"array", "linked", "unlimited", "deque", "priority", "transfer", "synchronous"})
    void scriptsOfOneThreadGoAsWithTheJdksQueue(String kind) {
        for (int script = 0; script < SCRIPTS; script++) {
            Random random = new Random(script);
            BlockingQueue<Integer> ours = OURS.get(kind).get();
            BlockingQueue<Integer> jdks = JDKS.get(kind).get();
            for (int step = 0; step < STEPS; step++) {
                int choice = random.nextInt(16);
                int value = random.nextInt(4);
                assertThat(step(ours, choice, value))
                        .as("script %d step %d choice %d value %d", script, step, choice, value)
                        .isEqualTo(step(jdks, choice, value));
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"array", "linked", "unlimited", "deque", "priority", "transfer", "synchronous"})
    void takeWaitsForAnElementAndInTheOrderOfArrival(String kind) throws InterruptedException {
        BlockingQueue<Integer> queue = OURS.get(kind).get();
        AtomicReference<Integer> taken = new AtomicReference<>();
        Waiting taker = Waiting.in(() -> taken.set(queue.take()));
        queue.put(7);
        taker.ends();
        assertThat(taken).hasValue(7);
        assertThat(queue).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"array", "linked", "unlimited", "deque", "priority", "transfer", "synchronous"})
    void waitingTakerCanBeInterruptedOrGivesUp(String kind) throws InterruptedException {
        BlockingQueue<Integer> queue = OURS.get(kind).get();
        assertThat(Waiting.in(queue::take).interrupted().outcome()).isInstanceOf(InterruptedException.class);
        assertThat(queue.poll(1, TimeUnit.MILLISECONDS)).isNull();
        Thread.currentThread().interrupt();
        assertThatThrownBy(queue::take).isInstanceOf(InterruptedException.class);
        assertThat(queue.offer(1)).isEqualTo(!kind.equals("synchronous"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"array", "linked", "deque"})
    void putWaitsForRoom(String kind) throws InterruptedException {
        BlockingQueue<Integer> queue = OURS.get(kind).get();
        queue.addAll(List.of(1, 2, 3));
        Waiting first = Waiting.in(() -> queue.put(4));
        Waiting second = Waiting.in(() -> queue.put(5));
        assertThat(queue.offer(6, 1, TimeUnit.MILLISECONDS)).isFalse();
        assertThat(second.interrupted().outcome()).isInstanceOf(InterruptedException.class);
        assertThat(queue.take()).isEqualTo(1);
        first.ends();
        assertThat(queue).containsExactly(2, 3, 4);
    }

    @Test
    void synchronousQueueServesTheLastComerFirstUnlessFair() throws InterruptedException {
        for (boolean fair : new boolean[] {false, true}) {
            SynchronousQueue<Integer> queue = new SynchronousQueue<>(fair);
            Waiting one = Waiting.in(() -> queue.put(1));
            Waiting two = Waiting.in(() -> queue.put(2));
            assertThat(queue.take()).isEqualTo(fair ? 1 : 2);
            assertThat(queue.poll()).isEqualTo(fair ? 2 : 1);
            one.ends();
            two.ends();
        }
    }

    @Test
    void transferWaitsUntilTheElementIsTaken() throws InterruptedException {
        LinkedTransferQueue<Integer> queue = new LinkedTransferQueue<>();
        assertThat(queue.tryTransfer(1)).isFalse();
        assertThat(queue.tryTransfer(2, 1, TimeUnit.MILLISECONDS)).isFalse();
        assertThat(queue).isEmpty();
        queue.put(3);
        Waiting giver = Waiting.in(() -> queue.transfer(4));
        assertThat(queue).containsExactly(3, 4);
        assertThat(queue.take()).isEqualTo(3);
        assertThat(queue.take()).isEqualTo(4);
        giver.ends();
        Waiting taker = Waiting.in(queue::take);
        assertThat(queue.hasWaitingConsumer()).isTrue();
        assertThat(queue.getWaitingConsumerCount()).isEqualTo(1);
        assertThat(queue.tryTransfer(5)).isTrue();
        taker.ends();
    }

    @Test
    void dequeWorksAtBothEnds() throws InterruptedException {
        BlockingDeque<Integer> deque = new LinkedBlockingDeque<>(2);
        Waiting taker = Waiting.in(() -> assertThat(deque.takeLast()).isEqualTo(1));
        deque.putFirst(1);
        taker.ends();
        deque.push(2);
        deque.addLast(3);
        assertThatThrownBy(() -> deque.addFirst(4)).isInstanceOf(IllegalStateException.class);
        assertThat(deque.offerFirst(4, 1, TimeUnit.MILLISECONDS)).isFalse();
        Waiting putter = Waiting.in(() -> deque.putFirst(4));
        assertThat(deque.pollLast()).isEqualTo(3);
        putter.ends();
        Iterator<Integer> descending = deque.descendingIterator();
        assertThat(descending.next()).isEqualTo(2);
        descending.remove();
        assertThat(deque.peekLast()).isEqualTo(4);
        assertThat(deque.removeLastOccurrence(4)).isTrue();
        assertThatThrownBy(deque::getFirst).isInstanceOf(java.util.NoSuchElementException.class);
    }

    @Test
    void delayQueueHoldsBackWhatIsNotDue() throws InterruptedException {
        DelayQueue<Due> queue = new DelayQueue<>();
        Due later = new Due(System.nanoTime() + TimeUnit.HOURS.toNanos(1));
        queue.put(later);
        assertThat(queue.poll()).isNull();
        assertThat(queue.poll(1, TimeUnit.MILLISECONDS)).isNull();
        assertThat(queue.peek()).isSameAs(later);
        assertThat(queue.drainTo(new ArrayList<>())).isZero();
        AtomicReference<Due> taken = new AtomicReference<>();
        Waiting taker = Waiting.in(() -> taken.set(queue.take()));
        Due soon = new Due(System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(2));
        queue.put(soon);
        taker.ends();
        assertThat(taken).hasValue(soon);
        assertThat(queue.size()).isEqualTo(1);
    }

    /** Due at a time of the JVM's clock. */
    private record Due(long atNanos) implements Delayed {
        @Override
        public long getDelay(TimeUnit unit) {
            return unit.convert(atNanos - System.nanoTime(), TimeUnit.NANOSECONDS);
        }

        @Override
        public int compareTo(Delayed other) {
            return Long.compare(atNanos, ((Due) other).atNanos);
        }
    }
}
