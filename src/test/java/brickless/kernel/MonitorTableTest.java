package brickless.kernel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class MonitorTableTest {
    private final MonitorTable table = new MonitorTable();

    @Test
    void oneObjectHasOneMonitorUntilItIsRemoved() {
        Object lock = new Object();
        Monitor monitor = table.findOrAdd(lock);
        assertThat(table.findOrAdd(lock)).isSameAs(monitor);
        assertThat(table.find(lock)).isSameAs(monitor);
        table.remove(monitor);
        assertThat(table.find(lock)).isNull();
        assertThat(table.size()).isZero();
    }

    @Test
    void aRemovedMonitorIsUsedAgainAndForgetsItsObject() {
        Monitor monitor = table.findOrAdd(new Object());
        table.remove(monitor);
        assertThat(monitor.lock).isNull();
        assertThat(table.findOrAdd(new Object())).isSameAs(monitor);
    }

    @Test
    void equalObjectsAreDifferentLocks() {
        assertThat(table.findOrAdd(new String("a"))).isNotSameAs(table.findOrAdd(new String("a")));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5})
    void everyMonitorIsFoundAmongManyInsertionsAndRemovals(int seed) {
        Random random = new Random(seed);
        List<Monitor> live = new ArrayList<>();
        for (int i = 0; i < 3_000; i++) {
            if (!live.isEmpty() && random.nextInt(20) < 9) {
                table.remove(live.remove(random.nextInt(live.size())));
            } else {
                live.add(table.findOrAdd(new Object()));
            }
            if (i % 50 == 0) {
                assertThat(live).allSatisfy(monitor -> assertThat(table.find(monitor.lock)).isSameAs(monitor));
            }
        }
        assertThat(table.size()).isEqualTo(live.size());
    }
}
