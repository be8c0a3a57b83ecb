package brickless.simulation.kit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.offset;

import brickless.simulation.Run;
import java.util.function.UnaryOperator;
import kit.RemoteNavigation;
import org.junit.jupiter.api.Test;

/** A navigation model over a loopback socket, both ends in simulated time. */
class RemoteNavigationTest {
    @Test
    void aRobotIsLedOverTheNetwork() {
        try (Run run = Kit.run(RemoteNavigation.class,
                Kit.world("<g data-robot='robot' transform='translate(1000 1000)'/>"),
                Kit.robot(""), UnaryOperator.identity())) {
            assertThat(run.outcome().exitStatus()).as(run.outcome() + " " + run.robot().printedLines()).contains(0);
            assertThat(run.robot().printedLines())
                    .contains("heard SET_POSE", "heard TRAVEL", "heard GOTO", "heard EXIT", "told MOVE_STOPPED",
                            "told PATH_COMPLETE", "told BATTERY").doesNotContain("not reached");
            assertThat(Kit.printed(run).number("volts")).isBetween(7.0, 9.0);
            assertThat(run.robot().xMetres()).isCloseTo(1.3, offset(0.03));
            assertThat(run.robot().yMetres()).isCloseTo(0.8, offset(0.03));
        }
    }
}
