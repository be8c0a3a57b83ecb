package brickless.kernel.hooks;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The JDK's hash table is the reference: same contents, and for keys with hash codes of their own the same order. */
class ProgramHashMapTest {
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5})
    void randomOperationsGiveWhatTheJdkGives(int seed) {
        Random random = new Random(seed);
        Map<Object, Integer> ours = new ProgramHashMap<>();
        Map<Object, Integer> reference = new HashMap<>();
        for (int i = 0; i < 2_000; i++) {
            Object key = random.nextInt(10) == 0 ? null : random.nextBoolean() ? "k" + random.nextInt(200)
                    : random.nextInt(300);
            int operation = random.nextInt(9);
            int value = random.nextInt(5);
            assertThat(apply(ours, operation, key, value)).isEqualTo(apply(reference, operation, key, value));
        }
        assertThat(new ArrayList<>(ours.keySet())).isEqualTo(new ArrayList<>(reference.keySet()));
        assertThat(new ArrayList<>(ours.values())).isEqualTo(new ArrayList<>(reference.values()));
        assertThat(ours).isEqualTo(reference).hasToString(reference.toString()).hasSameHashCodeAs(reference);
        assertThat(new ArrayList<>(new ProgramHashMap<>(ours).keySet()))
                .isEqualTo(new ArrayList<>(new HashMap<>(reference).keySet()));
    }

    private static Object apply(Map<Object, Integer> map, int operation, Object key, int value) {
        switch (operation) {
            case 0:
                return map.remove(key);
            case 1:
                return map.getOrDefault(key, -1);
            case 2:
                return map.putIfAbsent(key, value);
            case 3:
                return map.merge(key, value, Integer::sum);
            case 4:
                return map.computeIfAbsent(key, any -> value);
            case 5:
                return map.compute(key, (any, old) -> old == null ? value : null);
            case 6:
                return map.remove(key, value);
            case 7:
                return map.replace(key, value);
            default:
                return map.put(key, value);
        }
    }

    @Test
    void enumConstantsAndClassesAreFoundAndComeBackUnchanged() {
        Map<Object, String> map = new ProgramHashMap<>();
        for (TimeUnit unit : TimeUnit.values()) {
            map.put(unit, unit.name());
        }
        map.put(String.class, "class");
        assertThat(map).hasSize(8).containsEntry(TimeUnit.HOURS, "HOURS").containsKey(String.class);
        assertThat(map.keySet()).contains(TimeUnit.DAYS, String.class);
        assertThat(map.remove(TimeUnit.DAYS)).isEqualTo("DAYS");
        map.replaceAll((key, value) -> key.toString());
        assertThat(map.get(TimeUnit.HOURS)).isEqualTo("HOURS");
        map.entrySet().iterator().next().setValue("changed");
        assertThat(map.values()).contains("changed");
    }

    @Test
    void orderOfEnumConstantsFollowsFromTheirNames() {
        Map<TimeUnit, Integer> byConstant = new ProgramHashMap<>();
        Map<String, Integer> byName = new HashMap<>();
        for (TimeUnit unit : TimeUnit.values()) {
            byConstant.put(unit, 1);
            byName.put(unit.name(), 1);
        }
        List<String> names = new ArrayList<>();
        byConstant.keySet().forEach(unit -> names.add(unit.name()));
        assertThat(names).isEqualTo(new ArrayList<>(byName.keySet()));
    }

    @Test
    void iteratorsRemove() {
        Map<Object, Integer> map = new ProgramHashMap<>();
        map.put(TimeUnit.DAYS, 1);
        map.put("text", 2);
        for (Iterator<Map.Entry<Object, Integer>> entries = map.entrySet().iterator(); entries.hasNext();) {
            if (entries.next().getKey() == TimeUnit.DAYS) {
                entries.remove();
            }
        }
        assertThat(map).containsOnlyKeys("text");
    }

    @Test
    void clonesAreIndependent() {
        ProgramHashMap<Object, Integer> map = new ProgramHashMap<>();
        map.put(TimeUnit.DAYS, 1);
        Map<?, ?> copy = (Map<?, ?>) map.clone();
        map.clear();
        assertThat(copy).hasSize(1);
        assertThat(map).isEmpty();
    }

    @Test
    void serializedFormIsThatOfThePlainHashMap() throws IOException, ClassNotFoundException {
        ProgramHashMap<Object, Integer> map = new ProgramHashMap<>();
        map.put(TimeUnit.DAYS, 1);
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeObject(map);
        }
        try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray()))) {
            assertThat(in.readObject()).isExactlyInstanceOf(HashMap.class).isEqualTo(Map.of(TimeUnit.DAYS, 1));
        }
    }

    @Test
    void setsBehaveLikeTheJdks() {
        ProgramHashSet<Object> ours = new ProgramHashSet<>(List.of("a", 5, TimeUnit.DAYS));
        assertThat(ours).containsExactlyInAnyOrder("a", 5, TimeUnit.DAYS).isEqualTo(new HashSet<>(ours));
        assertThat(ours.add("a")).isFalse();
        assertThat(ours.remove(TimeUnit.DAYS)).isTrue();
        assertThat(ours.contains(TimeUnit.DAYS)).isFalse();
        assertThat(ours.toArray()).hasSize(2);
        assertThat(ours.stream().count()).isEqualTo(2);
    }
}
