package brickless.concurrent.util;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import brickless.concurrent.locks.Waiting;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.ConcurrentModificationException;
import java.util.EmptyStackException;
import java.util.Iterator;
import java.util.List;
import java.util.ListIterator;
import java.util.Map;
import java.util.NavigableMap;
import java.util.NavigableSet;
import java.util.Random;
import java.util.TreeMap;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Scripts of random steps go as with the JDK's classes; a failing script number reproduces. */
@Timeout(30)
class OldCollectionsTest {
    private static final int SCRIPTS = 100;
    private static final int STEPS = 60;

    /** A step; returns its result. */
    private interface Step {
        Object run();
    }

    private static String outcome(Step step) {
        try {
            return String.valueOf(step.run());
        } catch (RuntimeException e) {
            return e.getClass().getName();
        }
    }

    private static Object listStep(List<Integer> list, int choice, int a, int b) {
        switch (choice) {
            case 0:
            case 1:
            case 2:
                return list.add(b);
            case 3:
                list.add(a, b);
                return "inserted";
            case 4:
                return list.remove(a);
            case 5:
                return list.remove((Object) b);
            case 6:
                return list.set(a, b);
            case 7:
                return list.get(a) + " " + list.indexOf(b) + " " + list.lastIndexOf(b) + " " + list.contains(b);
            case 8:
                return list.addAll(a, List.of(b, b + 1));
            case 9:
                return list.removeAll(List.of(b)) + " " + list.retainAll(List.of(0, 1, 2, 3, 4)) + " "
                        + list.containsAll(List.of(a, b));
            case 10:
                list.subList(Math.min(a, b), Math.max(a, b)).clear();
                return "cleared";
            case 11:
                list.replaceAll(x -> x + 1);
                return list.removeIf(x -> x > 5);
            case 12:
                list.sort(null);
                return list.equals(new ArrayList<>(list)) + " " + list.hashCode();
            default:
                return walk(list.listIterator(), a, b);
        }
    }

    private static String walk(ListIterator<Integer> elements, int a, int b) {
        StringBuilder seen = new StringBuilder();
        while (elements.hasNext()) {
            int element = elements.next();
            seen.append(element);
            if (element == a) {
                elements.remove();
            } else if (element == b) {
                elements.set(a);
            }
        }
        return seen.toString();
    }

    private static Object vectorStep(Vector<Integer> v, int choice, int a, int b) {
        switch (choice) {
            case 0:
                return v.elementAt(a);
            case 1:
                v.setSize(a);
                return v.capacity();
            case 2:
                v.insertElementAt(b, a);
                return v.firstElement();
            case 3:
                v.removeElementAt(a);
                return v.lastElement();
            case 4:
                v.trimToSize();
                v.ensureCapacity(b);
                return v.capacity();
            case 5:
                return v.indexOf(b, a) + " " + v.lastIndexOf(b, a);
            default:
                return Collections.list(v.elements()) + " " + v.clone();
        }
    }

    private static Object vectorStep(java.util.Vector<Integer> v, int choice, int a, int b) {
        switch (choice) {
            case 0:
                return v.elementAt(a);
            case 1:
                v.setSize(a);
                return v.capacity();
            case 2:
                v.insertElementAt(b, a);
                return v.firstElement();
            case 3:
                v.removeElementAt(a);
                return v.lastElement();
            case 4:
                v.trimToSize();
                v.ensureCapacity(b);
                return v.capacity();
            case 5:
                return v.indexOf(b, a) + " " + v.lastIndexOf(b, a);
            default:
                return Collections.list(v.elements()) + " " + v.clone();
        }
    }

    @Test
    void vectorGoesAsTheJdksVector() {
        for (int script = 0; script < SCRIPTS; script++) {
            Random random = new Random(script);
            Vector<Integer> ours = new Vector<>(script % 3, script % 4);
            java.util.Vector<Integer> jdks = new java.util.Vector<>(script % 3, script % 4);
            for (int step = 0; step < STEPS; step++) {
                int choice = random.nextInt(21);
                int a = random.nextInt(6);
                int b = random.nextInt(6);
                String expected = outcome(() -> choice < 14 ? listStep(jdks, choice, a, b)
                        : vectorStep(jdks, choice - 14, a, b));
                assertThat(outcome(() -> choice < 14 ? listStep(ours, choice, a, b)
                        : vectorStep(ours, choice - 14, a, b)))
                        .as("script %d step %d choice %d", script, step, choice).isEqualTo(expected);
                assertThat(ours).isEqualTo(jdks).hasToString(jdks.toString());
                if (jdks.contains(null)) {
                    ours.removeAllElements();
                    jdks.removeAllElements();
                }
            }
        }
    }

    @Test
    void synchronizedListGoesAsTheJdks() {
        for (int script = 0; script < SCRIPTS; script++) {
            Random random = new Random(script);
            List<Integer> ours = SynchronizedCollections.synchronizedList(new ArrayList<>());
            List<Integer> jdks = Collections.synchronizedList(new ArrayList<>());
            for (int step = 0; step < STEPS; step++) {
                int choice = random.nextInt(14);
                int a = random.nextInt(6);
                int b = random.nextInt(6);
                assertThat(outcome(() -> listStep(ours, choice, a, b)))
                        .as("script %d step %d choice %d", script, step, choice)
                        .isEqualTo(outcome(() -> listStep(jdks, choice, a, b)));
                assertThat(ours).hasToString(jdks.toString());
            }
        }
    }

    private static Object mapStep(Map<String, Integer> map, int choice, String key, int value) {
        switch (choice) {
            case 0:
            case 1:
            case 2:
            case 3:
                return map.put(key, value);
            case 4:
                return map.remove(key);
            case 5:
                return map.get(key) + " " + map.containsKey(key) + " " + map.containsValue(value) + " "
                        + map.getOrDefault(key, -1);
            case 6:
                return map.putIfAbsent(key, value) + " " + map.replace(key, value) + " "
                        + map.replace(key, value, value + 1);
            case 7:
                return map.merge(key, value, (old, added) -> value == 3 ? null : old + added);
            case 8:
                return map.computeIfAbsent(key, k -> value) + " "
                        + map.computeIfPresent(key, (k, v) -> value == 4 ? null : v);
            case 9:
                return map.keySet().remove(key) + " " + map.values().remove(value) + " " + map.entrySet().size();
            case 10:
                map.replaceAll((k, v) -> v + 1);
                return map.remove(key, value) + " " + map.hashCode() + " " + map.equals(new TreeMap<>(map));
            case 11:
                return map.put(key, null);
            case 12:
                map.putAll(Map.of(key, value));
                return List.of(map.keySet().toArray()) + " " + map.values() + " " + map.entrySet();
            default:
                Iterator<Map.Entry<String, Integer>> entries = map.entrySet().iterator();
                if (entries.hasNext()) {
                    entries.next().setValue(value);
                    entries.remove();
                }
                return map.compute(key, (k, v) -> v == null ? value : v + value);
        }
    }

    @Test
    void hashtableGoesAsTheJdksInTheSameOrder() {
        for (int script = 0; script < SCRIPTS; script++) {
            Random random = new Random(script);
            Hashtable<String, Integer> ours = new Hashtable<>(script % 20 + 1, script % 3 == 0 ? 2f : 0.75f);
            java.util.Hashtable<String, Integer> jdks =
                    new java.util.Hashtable<>(script % 20 + 1, script % 3 == 0 ? 2f : 0.75f);
            for (int step = 0; step < 2 * STEPS; step++) {
                int choice = random.nextInt(14);
                String key = "key" + random.nextInt(40);
                int value = random.nextInt(6);
                assertThat(outcome(() -> mapStep(ours, choice, key, value)))
                        .as("script %d step %d choice %d", script, step, choice)
                        .isEqualTo(outcome(() -> mapStep(jdks, choice, key, value)));
                assertThat(ours.toString()).as("script %d step %d", script, step).isEqualTo(jdks.toString());
                assertThat(Collections.list(ours.keys())).isEqualTo(Collections.list(jdks.keys()));
                assertThat(ours.clone().toString()).isEqualTo(jdks.clone().toString());
            }
        }
    }

    @Test
    void hashtableRefusesNullsAndItsIteratorsFailFast() {
        Hashtable<String, String> table = new Hashtable<>(Map.of("a", "1", "b", "2"));
        assertThatThrownBy(() -> table.put(null, "")).isInstanceOf(NullPointerException.class);
        assertThatThrownBy(() -> table.get(null)).isInstanceOf(NullPointerException.class);
        assertThatThrownBy(() -> table.contains(null)).isInstanceOf(NullPointerException.class);
        assertThatThrownBy(() -> new Hashtable<>(-1)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new Hashtable<>(1, 0)).isInstanceOf(IllegalArgumentException.class);
        Iterator<String> keys = table.keySet().iterator();
        keys.next();
        table.put("c", "3");
        assertThatThrownBy(keys::next).isInstanceOf(ConcurrentModificationException.class);
        Iterator<String> elements = new Vector<>(List.of("x")).iterator();
        assertThat(elements.next()).isEqualTo("x");
    }

    @Test
    void stackCountsFromTheTop() {
        Stack<String> stack = new Stack<>();
        assertThatThrownBy(stack::pop).isInstanceOf(EmptyStackException.class);
        assertThatThrownBy(stack::peek).isInstanceOf(EmptyStackException.class);
        assertThat(stack.push("a")).isEqualTo("a");
        stack.push("b");
        assertThat(stack.search("a")).isEqualTo(2);
        assertThat(stack.search("z")).isEqualTo(-1);
        assertThat(stack.pop()).isEqualTo("b");
        assertThat(stack.empty()).isFalse();
    }

    @Test
    void vectorAndHashtableSurviveSerialization() throws Exception {
        Vector<String> vector = new Vector<>(List.of("a", "b"));
        Hashtable<String, Integer> table = new Hashtable<>(Map.of("a", 1, "b", 2));
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeObject(vector);
            out.writeObject(table);
        }
        try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray()))) {
            assertThat(in.readObject()).isEqualTo(vector);
            assertThat(in.readObject()).isEqualTo(table);
        }
    }

    @Test
    void whoHoldsTheMonitorOfACollectionKeepsOthersOutOfItAndItsViews() throws InterruptedException {
        Vector<Integer> vector = new Vector<>(List.of(1, 2, 3));
        Map<Integer, Integer> map = SynchronizedCollections.synchronizedMap(new TreeMap<>(Map.of(1, 1, 2, 2)));
        Collection<Integer> values = map.values();
        List<Integer> part = vector.subList(0, 2);
        List<Thread> intruders = new ArrayList<>();
        synchronized (vector) {
            synchronized (map) {
                for (Runnable intrusion : List.<Runnable>of(part::clear, values::clear)) {
                    Thread intruder = new Thread(intrusion);
                    intruder.start();
                    intruders.add(intruder);
                    while (intruder.getState() != Thread.State.BLOCKED) {
                        Thread.onSpinWait();
                    }
                }
                assertThat(vector).hasSize(3);
                assertThat(map).hasSize(2);
            }
        }
        for (Thread intruder : intruders) {
            intruder.join();
        }
        assertThat(vector).containsExactly(3);
        assertThat(map).isEmpty();
    }

    @Test
    void navigableWrappersGoAsTheirTargets() {
        NavigableSet<Integer> target = new TreeSet<>(List.of(1, 3, 5, 7));
        NavigableSet<Integer> set = SynchronizedCollections.synchronizedNavigableSet(target);
        assertThat(List.of(set.lower(3), set.floor(3), set.ceiling(4), set.higher(5), set.first(), set.last()))
                .containsExactly(1, 3, 5, 7, 1, 7);
        assertThat(set.subSet(1, 5)).containsExactly(1, 3);
        assertThat(set.headSet(5, true)).containsExactly(1, 3, 5);
        assertThat(set.tailSet(5)).containsExactly(5, 7);
        assertThat(set.descendingSet()).containsExactly(7, 5, 3, 1);
        assertThat(set.pollFirst()).isEqualTo(1);
        assertThat(set).isEqualTo(target).hasSameHashCodeAs(target);
        NavigableMap<Integer, String> map =
                SynchronizedCollections.synchronizedNavigableMap(new TreeMap<>(Map.of(1, "a", 2, "b", 3, "c")));
        assertThat(map.headMap(2)).containsOnlyKeys(1);
        assertThat(map.tailMap(2, false)).containsOnlyKeys(3);
        assertThat(map.subMap(1, 3)).containsOnlyKeys(1, 2);
        assertThat(map.descendingMap().firstKey()).isEqualTo(3);
        assertThat(map.descendingKeySet()).containsExactly(3, 2, 1);
        assertThat(map.keySet()).containsExactly(1, 2, 3);
        assertThat(map.pollLastEntry().getValue()).isEqualTo("c");
        assertThat(SynchronizedCollections.synchronizedSortedSet(new TreeSet<>(target)).headSet(5)).containsExactly(3);
        assertThat(SynchronizedCollections.synchronizedSortedMap(new TreeMap<>(map)).tailMap(2)).containsOnlyKeys(2);
        assertThat(SynchronizedCollections.synchronizedSet(target)).containsExactly(3, 5, 7);
        assertThat(SynchronizedCollections.synchronizedCollection(target).stream().mapToInt(x -> x).sum())
                .isEqualTo(15);
        assertThatThrownBy(() -> SynchronizedCollections.synchronizedList(null))
                .isInstanceOf(NullPointerException.class);
    }

    @Test
    void callbacksRunWithTheMonitorHeld() throws InterruptedException {
        Hashtable<Integer, Integer> table = new Hashtable<>(Map.of(1, 1));
        boolean[] held = new boolean[3];
        table.forEach((k, v) -> held[0] = Thread.holdsLock(table));
        Vector<Integer> vector = new Vector<>(List.of(1));
        vector.forEach(x -> held[1] = Thread.holdsLock(vector));
        Waiting.started(() -> vector.removeIf(x -> held[2] = Thread.holdsLock(vector))).ends();
        assertThat(held).containsExactly(true, true, true);
    }
}
