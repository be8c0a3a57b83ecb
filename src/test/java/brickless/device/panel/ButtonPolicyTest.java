package brickless.device.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ButtonPolicyTest {
    private static final long MILLI = 1_000_000;

    private final PanelBench bench = new PanelBench();
    private boolean scheduled;
    private final ButtonPolicy policy = new ButtonPolicy(bench.keys, () -> scheduled);

    private void stepUntil(long millis) {
        for (long at = (long) bench.millis() + 1; at <= millis; at++) {
            long now = at * MILLI;
            bench.at(at, () -> policy.step(now));
        }
    }

    /** Waits for a key to go down and up again, like a program. */
    private int nextKey() throws InterruptedException {
        int key = bench.keys.awaitChange(0, 0);
        bench.keys.awaitChange(key, 0);
        return key;
    }

    @Test
    void aWaitOfASecondGetsAPressOfAFifthOfASecond() throws InterruptedException {
        stepUntil(3000);
        assertThat(nextKey()).isEqualTo(2);
        assertThat(bench.millis()).isBetween(1200.0, 1203.0);
        assertThat(bench.events()).containsExactly("key 2 down by POLICY", "key 2 up by POLICY");
        assertThat(policy.presses()).isOne();
    }

    @Test
    void repeatedWaitsCycleThroughAllKeysButEscape() throws InterruptedException {
        stepUntil(10_000);
        List<Integer> keys = List.of(nextKey(), nextKey(), nextKey(), nextKey(), nextKey(), nextKey());
        assertThat(keys).containsExactly(2, 8, 16, 4, 1, 2);
        assertThat(bench.millis()).as("each a second after the release before").isBetween(7200.0, 7220.0);
    }

    @Test
    void nobodyPressesWhileSomebodyElseIsGoingTo() throws InterruptedException {
        stepUntil(6000);
        scheduled = true;
        bench.at(4000, () -> scheduled = false).pressAt(4000, 32, 100);
        assertThat(nextKey()).isEqualTo(32);
        assertThat(policy.presses()).isZero();
    }

    @Test
    void listenersAndBusyProgramsGetNoPresses() throws InterruptedException {
        stepUntil(5000);
        bench.pressAt(4000, 32, 100);
        bench.keys.awaitListenerEvent(0);
        assertThat(bench.millis()).isGreaterThan(3999);
        assertThat(policy.presses()).isZero();
    }

    /** The policy does not look all the time, but no wait is answered late for that: begun early or late between two looks. */
    @ParameterizedTest
    @ValueSource(ints = {1, 99, 100, 101, 450, 899, 900, 901, 999, 1000, 1001, 1750, 2700})
    void wheneverTheWaitBeginsThePressComesAfterASecond(int begin) throws InterruptedException {
        stepUntil(6000);
        bench.processor().charge(begin * MILLI - MILLI / 2);
        bench.keys.awaitChange(0, 0);
        assertThat(bench.millis()).isBetween(begin + 1000.0, begin + 1002.0);
    }

    /** Short waits with hardly anything between them count as one, and it may be answered soon after the last of them has begun. */
    @Test
    void repeatedShortWaitsAreAnsweredAfterASecondAltogether() throws InterruptedException {
        stepUntil(3000);
        bench.processor().charge(300 * MILLI);
        while (bench.keys.awaitChange(0, 7 * MILLI) == 0) {
            bench.processor().charge(MILLI / 20);
        }
        assertThat(bench.millis()).isBetween(1300.0, 1302.0);
    }
}
