package brickless.simulation.kit;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.simulation.Run;
import java.util.function.UnaryOperator;
import kit.Polls;
import org.junit.jupiter.api.Test;

class ArbitratorPollingTest {
    @Test
    void behavioursAreAskedEveryTwoMilliseconds() {
        try (Run run = Kit.run(Polls.class, Kit.EMPTY, Kit.BENCH, UnaryOperator.identity())) {
            assertThat(Kit.printed(run).number("asked")).isBetween(490.0, 501.0);
            assertThat(run.robot().printedLines()).hasSize(2);
        }
    }
}
