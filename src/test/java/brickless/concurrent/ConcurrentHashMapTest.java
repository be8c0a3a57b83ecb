package brickless.concurrent;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import brickless.concurrent.locks.Waiting;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(30)
class ConcurrentHashMapTest {
    private static final int STEPS = 2000;

    private static Integer step(Map<String, Integer> map, int choice, String key, int value) {
        switch (choice) {
            case 0:
                return map.computeIfAbsent(key, k -> value == 0 ? null : value);
            case 1:
                return map.computeIfPresent(key, (k, old) -> value == 0 ? null : old + value);
            case 2:
                return map.compute(key, (k, old) -> value == 0 ? null : old == null ? value : old + value);
            case 3:
                return map.merge(key, value, (old, added) -> added == 0 ? null : old + added);
            default:
                return map.put(key, value);
        }
    }

    @Test
    void computesWhatTheJdksMapComputes() {
        Random random = new Random(1);
        Map<String, Integer> ours = new ConcurrentHashMap<>();
        Map<String, Integer> jdks = new java.util.concurrent.ConcurrentHashMap<>();
        for (int i = 0; i < STEPS; i++) {
            int choice = random.nextInt(5);
            String key = "key" + random.nextInt(8);
            int value = random.nextInt(4);
            assertThat(step(ours, choice, key, value)).as("step %d", i).isEqualTo(step(jdks, choice, key, value));
            assertThat(ours).isEqualTo(jdks);
        }
    }

    @Test
    void functionThatWaitsDoesNotKeepOthersFromTheMap() throws InterruptedException {
        ConcurrentHashMap<String, Integer> map = new ConcurrentHashMap<>();
        CountDownLatch gate = new CountDownLatch(1);
        Waiting computing = Waiting.in(() -> map.compute("key", (k, old) -> {
            gateAwait(gate);
            return old == null ? 1 : old + 1;
        }));
        map.put("key", 10);
        gate.countDown();
        computing.ends();
        assertThat(map).containsEntry("key", 11);
    }

    private static void gateAwait(CountDownLatch gate) {
        try {
            gate.await();
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    @Test
    void valueIsComputedOnceForAllWhoAskForIt() throws InterruptedException {
        ConcurrentHashMap<String, Integer> map = new ConcurrentHashMap<>();
        CountDownLatch gate = new CountDownLatch(1);
        AtomicInteger calls = new AtomicInteger();
        Waiting first = Waiting.in(() -> map.computeIfAbsent("key", k -> {
            gateAwait(gate);
            return calls.incrementAndGet();
        }));
        Waiting second = Waiting.started(() -> map.computeIfAbsent("key", k -> calls.incrementAndGet()));
        gate.countDown();
        first.ends();
        second.ends();
        assertThat(calls).hasValue(1);
    }

    @Test
    void nullsAreRefused() {
        ConcurrentHashMap<String, Integer> map = new ConcurrentHashMap<>();
        assertThatThrownBy(() -> map.compute(null, (k, v) -> 1)).isInstanceOf(NullPointerException.class);
        assertThatThrownBy(() -> map.merge("key", null, Integer::sum)).isInstanceOf(NullPointerException.class);
        assertThatThrownBy(() -> map.computeIfAbsent("key", null)).isInstanceOf(NullPointerException.class);
        assertThatThrownBy(() -> map.computeIfPresent(null, (k, v) -> 1)).isInstanceOf(NullPointerException.class);
    }
}
