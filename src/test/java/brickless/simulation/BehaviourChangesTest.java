package brickless.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class BehaviourChangesTest {
    private static final long MILLI = 1_000_000;
    private final List<String> written = new ArrayList<>();
    private final BehaviourChanges changes = new BehaviourChanges((time, behaviour) -> written.add(time / MILLI + ":"
            + behaviour));

    @Test
    void everyOtherBehaviourIsWrittenAtOnce() {
        changes.set(1 * MILLI, 0);
        changes.set(2 * MILLI, 2);
        changes.set(3 * MILLI, 0);
        assertThat(written).containsExactly("1:0", "2:2", "3:0");
    }

    @Test
    void anActionStartedAgainAndAgainIsWrittenOnce() {
        for (int i = 0; i < 100; i++) {
            changes.set(2 * i * MILLI, 1);
            changes.set((2 * i + 1) * MILLI, -1);
            changes.step((2 * i + 2) * MILLI);
        }
        assertThat(written).containsExactly("0:1");
    }

    @Test
    void noneIsWrittenWhenItLasts() {
        changes.set(0, 1);
        changes.set(10 * MILLI, -1);
        changes.step(29 * MILLI);
        assertThat(written).containsExactly("0:1");
        changes.step(30 * MILLI);
        changes.step(32 * MILLI);
        assertThat(written).containsExactly("0:1", "30:-1");
    }

    @Test
    void noneRepeatedDoesNotBeginAnew() {
        changes.set(0, 1);
        changes.set(10 * MILLI, -1);
        changes.set(25 * MILLI, -1);
        changes.step(30 * MILLI);
        assertThat(written).containsExactly("0:1", "30:-1");
        assertThat(changes.current()).isEqualTo(-1);
    }
}
