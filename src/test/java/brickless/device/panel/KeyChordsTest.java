package brickless.device.panel;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.hardware.ScreenSocket;
import org.junit.jupiter.api.Test;

class KeyChordsTest {
    private static final long MILLI = 1_000_000;
    private static final int LEFT_RIGHT = 24;
    private static final int DOWN_ENTER = 6;

    private final PanelBench bench = new PanelBench();
    private int ended;
    private final KeyChords chords = new KeyChords(bench.keys, bench.screen, () -> ended++);

    /** Lets time pass with a look at the keys in every millisecond. */
    private void pass(long millis) {
        for (int i = 0; i < millis; i++) {
            bench.processor().charge(MILLI);
            chords.step(bench.processor().nowNanos());
        }
    }

    private void hold(int keys, long millis) {
        bench.keys.press(keys);
        pass(millis);
        bench.keys.release(keys);
        pass(150);
    }

    private boolean ink(int index) {
        return bench.screen.displayed()[index] != 0;
    }

    @Test
    void downAndEnterEndTheProgramOncePerPress() {
        hold(DOWN_ENTER, 1000);
        assertThat(ended).isOne();
        hold(DOWN_ENTER, 250);
        assertThat(ended).isEqualTo(2);
    }

    @Test
    void otherCombinationsDoNot() {
        hold(DOWN_ENTER | 1, 1000);
        hold(2, 1000);
        hold(4, 1000);
        bench.keys.simulate(DOWN_ENTER, true);
        pass(1000);
        assertThat(ended).isZero();
    }

    @Test
    void leftAndRightShowEachLayerAloneThenAllTogether() {
        bench.screen.layer("LCD")[0] = 1;
        int lastRow = ScreenSocket.ROW_BYTES * (ScreenSocket.HEIGHT - 1);
        bench.screen.layer("STDOUT")[lastRow] = 1;
        bench.screen.settle();
        assertThat(ink(0) && ink(lastRow)).isTrue();
        hold(LEFT_RIGHT, 500);
        assertThat(ink(0) && !ink(lastRow)).as("LCD alone").isTrue();
        hold(LEFT_RIGHT, 500);
        assertThat(!ink(0) && ink(lastRow)).as("STDOUT alone").isTrue();
        hold(LEFT_RIGHT, 500);
        assertThat(ink(0) && ink(lastRow)).as("all").isTrue();
    }

    @Test
    void nameOfTheLayerIsShownForTwoSeconds() {
        bench.screen.layer("LCD");
        hold(LEFT_RIGHT, 200);
        assertThat(count()).isGreaterThan(300);
        pass(2200);
        assertThat(count()).isZero();
    }

    private int count() {
        int count = 0;
        for (byte b : bench.screen.displayed()) {
            count += Integer.bitCount(b & 0xff);
        }
        return count;
    }
}
