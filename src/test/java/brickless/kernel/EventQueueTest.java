package brickless.kernel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class EventQueueTest {
    private final EventQueue queue = new EventQueue();
    private final List<String> ran = new ArrayList<>();

    @Test
    void eventsComeByTimeAndThoseOfOneTimeInOrderOfInsertion() {
        add("c", 20);
        add("a", 10);
        add("d", 20);
        add("b", 10);
        add("e", 20);
        runAll();
        assertThat(ran).containsExactly("a", "b", "c", "d", "e");
    }

    @Test
    void anEmptyQueueIsDueNever() {
        assertThat(queue.nextTimeNanos()).isEqualTo(Long.MAX_VALUE);
    }

    @Test
    void aRemovedEventNeverRunsAndCanBeQueuedAgain() {
        Event event = add("x", 5);
        add("y", 7);
        queue.remove(event);
        queue.remove(event);
        assertThat(event.queued()).isFalse();
        queue.add(event, 9);
        runAll();
        assertThat(ran).containsExactly("y", "x");
    }

    @Test
    void aQueuedEventCannotBeQueuedTwice() {
        Event event = add("x", 5);
        assertThatThrownBy(() -> queue.add(event, 6)).isInstanceOf(IllegalStateException.class);
    }

    @Test
    void theNextTimeIsTheFirstEventsAfterEveryChange() {
        Event late = add("late", 9);
        assertThat(queue.nextTimeNanos()).isEqualTo(9);
        Event early = add("early", 5);
        assertThat(queue.nextTimeNanos()).isEqualTo(5);
        add("between", 7);
        assertThat(queue.nextTimeNanos()).isEqualTo(5);
        queue.remove(early);
        assertThat(queue.nextTimeNanos()).isEqualTo(7);
        queue.remove(late);
        assertThat(queue.nextTimeNanos()).isEqualTo(7);
        queue.poll();
        assertThat(queue.nextTimeNanos()).isEqualTo(Long.MAX_VALUE);
        add("cleared", 3);
        queue.clear();
        assertThat(queue.nextTimeNanos()).isEqualTo(Long.MAX_VALUE);
    }

    @Test
    void clearingLetsGoOfAllEvents() {
        Event event = add("x", 5);
        queue.clear();
        assertThat(queue.size()).isZero();
        assertThat(event.queued()).isFalse();
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9})
    void randomInsertionsAndRemovalsAgreeWithASortedList(int seed) {
        Random random = new Random(seed);
        List<Event> expected = new ArrayList<>();
        for (int i = 0; i < 500; i++) {
            if (!expected.isEmpty() && random.nextInt(3) == 0) {
                queue.remove(expected.remove(random.nextInt(expected.size())));
            } else {
                Event event = new Event(() -> { });
                queue.add(event, random.nextInt(50));
                expected.add(event);
            }
        }
        expected.sort(Comparator.comparingLong((Event event) -> event.timeNanos)
                .thenComparingLong(event -> event.sequence));
        List<Event> polled = new ArrayList<>();
        while (queue.size() > 0) {
            polled.add(queue.poll());
        }
        assertThat(polled).isEqualTo(expected);
    }

    private Event add(String name, long time) {
        Event event = new Event(() -> ran.add(name));
        queue.add(event, time);
        return event;
    }

    private void runAll() {
        while (queue.size() > 0) {
            queue.poll().run();
        }
    }
}
