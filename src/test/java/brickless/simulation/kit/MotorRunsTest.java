package brickless.simulation.kit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.offset;

import brickless.simulation.Run;
import java.util.function.UnaryOperator;
import kit.OnlyRotates;
import kit.Rotations;
import kit.Stalls;
import kit.Together;
import kit.Unregulated;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;

/** Whole programs that move motors, held against the numbers that are known of leJOS on a brick. */
class MotorRunsTest {
    private static Run run(Class<?> program) {
        return Kit.run(program, Kit.EMPTY, Kit.BENCH, UnaryOperator.identity());
    }

    private static Printed printed(Class<?> program) {
        try (Run run = run(program)) {
            assertThat(run.outcome().kind()).isEqualTo("exited");
            return Kit.printed(run);
        }
    }

    @Nested
    class Regulated {
        private static Printed lines;

        @BeforeAll
        static void run() {
            lines = printed(Rotations.class);
        }

        @Test
        void highestSpeedIs105DegreesPerSecondAndVolt() {
            assertThat(lines.number("maxSpeed")).isCloseTo(105, offset(0.01));
        }

        @Test
        void rotationsTakeRampsCruiseAndSettling() {
            assertThat(lines.number("at90")).isCloseTo(4170, offset(40.0));
            assertThat(lines.number("at360")).isCloseTo(1180, offset(30.0));
            assertThat(lines.number("at720")).isCloseTo(720, offset(30.0));
            assertThat(lines.number("back")).isCloseTo(309 + 120, offset(30.0));
            assertThat(lines.number("triangle")).isBetween(180.0, 300.0);
            assertThat(lines.number("nothing")).isLessThan(2);
        }

        @Test
        void rotationsEndWithinTwoDegreesAndAreOverThen() {
            for (String name : new String[] {"at90:360", "at360:360", "at720:360", "back:-90", "triangle:10",
                    "tooFast:3600"}) {
                String[] parts = name.split(":");
                assertThat(lines.number(parts[0], 1)).as(name).isCloseTo(Double.parseDouble(parts[1]), offset(2.0));
                assertThat(lines.words(parts[0]).get(2)).as(name).isEqualTo("false");
            }
        }

        @Test
        void unreachableSpeedIsAsFastAsTheMotorCan() {
            assertThat(lines.number("tooFast")).isBetween(3600 / 0.95, 4500.0);
        }

        @Test
        void manySmallRotationsDoNotDrift() {
            assertThat(lines.number("drift")).isCloseTo(210, offset(2.0));
            assertThat(lines.words("drift").subList(1, 3)).containsExactly("210.0", "210");
        }

        @Test
        void endlessMovesHaveTheGreatestLimit() {
            assertThat(lines.words("endless")).containsExactly("true", "2147483647");
            assertThat(lines.number("cruising")).isEqualTo(360);
        }

        @Test
        void stopBrakesAlongTheRampAndSettles() {
            assertThat(lines.number("stop")).isCloseTo(180, offset(25.0));
            assertThat(lines.number("stop", 1)).isCloseTo(10.8, offset(3.0));
            assertThat(lines.number("stop", 2)).isZero();
            assertThat(lines.number("idleStop")).isLessThan(3);
        }

        @Test
        void reversalRampsThroughZeroWithoutAStop() {
            assertThat(lines.number("reversing")).isCloseTo(0, offset(15.0));
            assertThat(lines.words("reversing").get(1)).isEqualTo("true");
            assertThat(lines.number("reversed")).isEqualTo(-360);
            assertThat(lines.words("stopping")).containsExactly("true", "2147483647");
        }

        @Test
        void speedZeroLatchesUntilTheNextMove() {
            assertThat(lines.words("latched")).containsExactly("false");
            assertThat(lines.words("stillLatched")).containsExactly("false");
            assertThat(lines.words("unlatched")).containsExactly("true");
        }
    }

    @Test
    void aBlockedMotorStallsAfterLagAndStallTime() {
        Printed lines = printed(Stalls.class);
        assertThat(lines.words("free")).containsExactly("false");
        assertThat(lines.number("default")).isBetween(1050.0, 1250.0);
        assertThat(lines.words("default").subList(1, 3)).containsExactly("true", "false");
        assertThat(lines.number("default", 3)).isCloseTo(90, offset(1.0));
        assertThat(lines.words("freed").get(0)).isEqualTo("false");
        assertThat(lines.number("again")).isBetween(200.0, 330.0);
    }

    @Test
    void listenersHearEveryStartBeforeAndEveryEnd() {
        assertThat(printed(Stalls.class).lines().stream().filter(line -> line.contains("=")).toList()).containsExactly(
                "started moving=false", "stopped stalled=false", "started moving=false", "stopped stalled=true",
                        "started moving=false",
                "stopped stalled=false", "started moving=false", "stopped stalled=true", "started moving=false",
                        "stopped stalled=true");
    }

    @Test
    void synchronisedMotorsRunTogether() {
        Printed lines = printed(Together.class);
        assertThat(lines.number("recorded")).isLessThan(3);
        assertThat(lines.words("recorded").subList(1, 3)).containsExactly("false", "false");
        assertThat(lines.words("sent")).containsExactly("true", "true");
        assertThat(lines.number("apart")).isLessThanOrEqualTo(2);
        assertThat(lines.number("apart", 1)).isCloseTo(360, offset(2.0));
        assertThat(lines.number("apart", 2)).isCloseTo(360, offset(2.0));
        assertThat(lines.number("hold")).isCloseTo(0, offset(2.0));
    }

    @Test
    void powerDrivesAnUnregulatedMotor() {
        Printed lines = printed(Unregulated.class);
        assertThat(lines.words("initial")).containsExactly("0", "false");
        assertThat(lines.words("powered")).containsExactly("false", "true");
        assertThat(lines.number("speed5")).isZero();
        assertThat(lines.number("speed25")).isBetween(150.0, 250.0);
        assertThat(lines.number("speed50")).isBetween(400.0, 500.0);
        assertThat(lines.number("speed100")).isCloseTo(1050 * 8.16 / 9, offset(20.0));
        assertThat(lines.number("backward")).isCloseTo(-lines.number("speed100"), offset(6.0));
        assertThat(lines.words("reset")).containsExactly("0");
    }

    @Test
    void coastingRunsOnMuchFartherThanBraking() {
        Printed lines = printed(Unregulated.class);
        assertThat(lines.number("coast")).isGreaterThan(5 * lines.number("brake"));
    }

    @Test
    void blockingMovesNeedNoSwitches() {
        try (Run run = run(OnlyRotates.class)) {
            assertThat(run.time().toSeconds()).isGreaterThan(10);
            assertThat(run.report().contextSwitches()).isZero();
        }
    }

    /** One to begin watching and one at the end, however long the move is. */
    @Test
    void aListenerCostsTwoSwitchesAMove() {
        try (Run run = run(Stalls.class)) {
            assertThat(run.report().contextSwitches()).isLessThanOrEqualTo(2 * 5 + 2);
        }
    }
}
