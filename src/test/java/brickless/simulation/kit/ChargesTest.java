package brickless.simulation.kit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.offset;

import brickless.simulation.Run;
import java.util.function.UnaryOperator;
import kit.BusCost;
import kit.Charges;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What calls cost in simulated time; the estimates stand in {@code Costs} and {@code PanelCharges}. */
class ChargesTest {
    /** The loop and the lambda around each call. */
    private static final double LOOP = 1;
    private static Printed lines;

    @BeforeAll
    static void run() {
        try (Run run = Kit.run(Charges.class, Worlds.ROOM, Worlds.EV3, UnaryOperator.identity())) {
            lines = Kit.printed(run);
        }
    }

    @ParameterizedTest
    @CsvSource({"loop, 0, 0.1", "serialRead, 200, 3", "analogueRead, 200, 3", "tacho, 20, 2", "isMoving, 20, 2",
            "command, 320, 10",
        "println, 500, 20", "drawString, 500, 80", "clock, 2, 0.5", "key, 20, 2", "led, 100, 2", "refresh, 200, 2",
                "monitor, 0.5, 0.5",
        "kilobyte, 4, 0.5", "thread, 500, 5"})
    void aCallCostsMicroseconds(String call, double microseconds, double tolerance) {
        assertThat(lines.number("cost." + call) - LOOP).isCloseTo(microseconds, offset(tolerance));
    }

    @Test
    void yieldsInARowCostUpToAMillisecond() {
        assertThat(lines.number("cost.yield")).isBetween(900.0, 1002.0);
    }

    @Test
    void aTransactionOnTheBusTakesFiveMilliseconds() {
        try (Run run = Kit.run(BusCost.class, Kit.EMPTY, Worlds.OLDER, UnaryOperator.identity())) {
            assertThat(Kit.printed(run).number("cost.transaction")).isCloseTo(5000, offset(10.0));
        }
    }
}
