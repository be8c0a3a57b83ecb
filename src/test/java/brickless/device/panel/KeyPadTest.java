package brickless.device.panel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class KeyPadTest {
    private static final int ENTER = 2;
    private static final int DOWN = 4;
    private static final int LEFT = 16;
    private static final long MILLI = 1_000_000;

    private final PanelBench bench = new PanelBench();

    @Test
    void waitEndsWhenAKeyMoves() throws InterruptedException {
        bench.pressAt(70, ENTER, 30);
        assertThat(bench.keys.awaitChange(0, 0)).isEqualTo(ENTER);
        assertThat(bench.millis()).isBetween(70.0, 72.0);
        assertThat(bench.keys.awaitChange(ENTER, 0)).isZero();
        assertThat(bench.millis()).isBetween(100.0, 102.0);
    }

    @Test
    void waitEndsAtOnceWhenTheStateIsUnknownAndAfterItsTimeLimit() throws InterruptedException {
        bench.keys.press(DOWN);
        assertThat(bench.keys.awaitChange(0, 0)).isEqualTo(DOWN);
        assertThat(bench.millis()).isLessThan(1);
        assertThat(bench.keys.awaitChange(DOWN, 40 * MILLI)).isEqualTo(DOWN);
        assertThat(bench.millis()).isBetween(40.0, 41.0);
    }

    @Test
    void interruptEndsTheWait() {
        Thread.currentThread().interrupt();
        assertThatThrownBy(() -> bench.keys.awaitChange(0, 0)).isInstanceOf(InterruptedException.class);
        assertThat(bench.keys.waitingSince()).isEmpty();
    }

    @Test
    void handAndProgramHoldKeysTogether() {
        bench.keys.press(ENTER);
        bench.keys.simulate(ENTER | LEFT, true);
        bench.keys.release(ENTER);
        assertThat(bench.keys.pressed()).isEqualTo(ENTER | LEFT);
        assertThat(bench.keys.heldByHand()).isZero();
        bench.keys.simulate(ENTER | LEFT, false);
        assertThat(bench.keys.pressed()).isZero();
        assertThat(bench.events())
                .containsExactly("key 2 down by HAND", "key 16 down by PROGRAM", "key 18 up by PROGRAM");
    }

    @Test
    void onlyWaitsOfTheProgramCountAndKeyMovesStartTheCountAnew() throws InterruptedException {
        long[] since = new long[3];
        bench.at(50, () -> since[0] = bench.keys.waitingSince().orElse(-1));
        bench.pressAt(60, ENTER, 10);
        bench.keys.awaitListenerEvent(0);
        bench.keys.awaitListenerEvent(ENTER);
        bench.at(150, () -> since[1] = bench.keys.waitingSince().orElse(-1));
        bench.keys.awaitChange(0, 100 * MILLI);
        bench.at(200, () -> since[2] = bench.keys.waitingSince().orElse(-1));
        bench.keys.awaitChange(0, 100 * MILLI);
        assertThat(since[0]).isEqualTo(-1);
        assertThat(since[1]).isBetween(70 * MILLI, 72 * MILLI);
        assertThat(since[2]).as("two waits with nothing between are one").isEqualTo(since[1]);
        bench.processor().charge(MILLI);
        bench.at(220, () -> since[2] = bench.keys.waitingSince().orElse(-1));
        bench.at(300, () -> since[2] = bench.keys.waitingSince().orElse(-1));
        bench.keys.awaitChange(0, 100 * MILLI);
        assertThat(since[2]).as("the program did something in between").isGreaterThan(270 * MILLI);
    }
}
