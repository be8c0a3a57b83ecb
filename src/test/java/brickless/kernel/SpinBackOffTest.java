package brickless.kernel;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class SpinBackOffTest {
    private final SpinBackOff backOff = new SpinBackOff();

    private int waitsUntilTheNextSpin() {
        int waits = 0;
        while (backOff.spins() == 0) {
            waits++;
        }
        return waits;
    }

    @Test
    void everyFailureInARowDoublesTheWaitsWithoutSpinningUpToALimit() {
        for (int expected : new int[] {1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 1024}) {
            backOff.failed();
            assertThat(waitsUntilTheNextSpin()).isEqualTo(expected);
        }
    }

    @Test
    void aSuccessMakesTheNextFailureAFirstOne() {
        backOff.failed();
        backOff.failed();
        waitsUntilTheNextSpin();
        backOff.succeeded();
        assertThat(waitsUntilTheNextSpin()).isZero();
        backOff.failed();
        assertThat(waitsUntilTheNextSpin()).isEqualTo(1);
    }

    @Test
    void nobodySpinsWhenThereAreTooManyRunsForThisMachine() {
        int runs = Runtime.getRuntime().availableProcessors();
        for (int i = 0; i < runs; i++) {
            SpinBackOff.runBegins();
        }
        try {
            assertThat(backOff.spins()).isZero();
        } finally {
            for (int i = 0; i < runs; i++) {
                SpinBackOff.runEnds();
            }
        }
    }
}
