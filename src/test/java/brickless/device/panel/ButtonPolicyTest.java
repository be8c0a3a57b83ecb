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
    private boolean stimuli;
    private boolean motorsRest = true;
    private final ButtonPolicy policy = new ButtonPolicy(bench.keys, new ButtonPolicy.Circumstances() {
        @Override
        public boolean keyPressesToCome() {
            return scheduled;
        }

        @Override
        public boolean stimuliToCome() {
            return stimuli;
        }

        @Override
        public boolean motorsRest() {
            return motorsRest;
        }
    });

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
        assertThat(policy.presses()).containsExactly(2);
    }

    @Test
    void repeatedWaitsCycleThroughAllKeysButEscape() throws InterruptedException {
        stepUntil(10_000);
        List<Integer> keys = List.of(nextKey(), nextKey(), nextKey(), nextKey(), nextKey(), nextKey());
        assertThat(keys).containsExactly(2, 8, 16, 4, 1, 2);
        assertThat(bench.millis()).as("each a second after the release before, and 7 ms later each time")
                .isBetween(7305.0, 7330.0);
    }

    @Test
    void nobodyPressesWhileSomebodyElseIsGoingTo() throws InterruptedException {
        stepUntil(6000);
        scheduled = true;
        bench.at(4000, () -> scheduled = false).pressAt(4000, 32, 100);
        assertThat(nextKey()).isEqualTo(32);
        assertThat(policy.presses()).isEmpty();
    }

    @Test
    void listenersAndBusyProgramsGetNoPresses() throws InterruptedException {
        stepUntil(5000);
        bench.pressAt(4000, 32, 100);
        bench.keys.awaitListenerEvent(0);
        assertThat(bench.millis()).isGreaterThan(3999);
        assertThat(policy.presses()).isEmpty();
    }

    private void pause(long millis) {
        bench.processor().charge(millis * MILLI);
    }

    /** Looks at a key every so often until it is down; gives up after a time. */
    private double askUntilDown(int key, long everyMillis, long atMostMillis) throws InterruptedException {
        while (bench.millis() < atMostMillis) {
            if ((bench.keys.pressed(key) & key) != 0) {
                return bench.millis();
            }
            pause(everyMillis);
        }
        return Double.NaN;
    }

    @Test
    void aKeyThatIsAskedForThreeSecondsIsPressed() throws InterruptedException {
        stepUntil(6000);
        assertThat(askUntilDown(4, 20, 6000)).isBetween(3000.0, 3030.0);
        assertThat(bench.events()).containsExactly("key 4 down by POLICY");
    }

    @Test
    void ofTheKeysAskedForTheNextOfTheCycleIsPressed() throws InterruptedException {
        stepUntil(12_000);
        askUntilDown(1 | 8, 20, 12_000);
        pause(250);
        askUntilDown(1 | 8, 20, 12_000);
        assertThat(bench.events()).containsExactly("key 8 down by POLICY", "key 8 up by POLICY",
                "key 1 down by POLICY");
    }

    @Test
    void escapeAloneIsNeverPressed() throws InterruptedException {
        stepUntil(10_000);
        assertThat(askUntilDown(32, 20, 9000)).isNaN();
        assertThat(policy.presses()).isEmpty();
    }

    @Test
    void aProgramThatLooksEachSecondFindsTheKeyStillDown() throws InterruptedException {
        stepUntil(9000);
        assertThat(askUntilDown(2, 1000, 9000)).isBetween(3000.0, 4100.0);
        pause(300);
        assertThat(bench.events()).as("let go once the program has seen it")
                .containsExactly("key 2 down by POLICY", "key 2 up by POLICY");
    }

    @Test
    void aKeyNobodyLooksAtAgainIsLetGo() throws InterruptedException {
        stepUntil(12_000);
        bench.at(3001, () -> motorsRest = true);
        motorsRest = false;
        askUntilDown(2, 20, 5900);
        pause(6000);
        assertThat(bench.events()).containsExactly("key 2 down by POLICY", "key 2 up by POLICY");
    }

    @Test
    void whileAMotorTurnsOrStimuliAreToComeNothingIsPressed() throws InterruptedException {
        stepUntil(12_000);
        motorsRest = false;
        assertThat(askUntilDown(2, 20, 5000)).isNaN();
        motorsRest = true;
        stimuli = true;
        assertThat(askUntilDown(2, 20, 10_000)).isNaN();
        assertThat(policy.presses()).isEmpty();
    }

    /**
     * The policy does not look all the time, but no wait is answered late for that: begun early or late between two
     * looks.
     */
    @ParameterizedTest
    @ValueSource(ints = {1, 99, 100, 101, 450, 899, 900, 901, 999, 1000, 1001, 1750, 2700})
    void wheneverTheWaitBeginsThePressComesAfterASecond(int begin) throws InterruptedException {
        stepUntil(6000);
        bench.processor().charge(begin * MILLI - MILLI / 2);
        bench.keys.awaitChange(0, 0);
        assertThat(bench.millis()).isBetween(begin + 1000.0, begin + 1002.0);
    }

    /**
     * Short waits with hardly anything between them count as one, and it may be answered soon after the last of them
     * has begun.
     */
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
