package brickless.junit;

import java.math.BigDecimal;
import java.time.Duration;

/** Durations as people read them. */
final class Seconds {
    private Seconds() {}

    /** Seconds without needless zeros: {@code 2.5}. */
    static String text(Duration duration) {
        return BigDecimal.valueOf(duration.toNanos(), 9).stripTrailingZeros().toPlainString();
    }
}
