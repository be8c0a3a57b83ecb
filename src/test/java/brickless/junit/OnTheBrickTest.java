package brickless.junit;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests whose body runs on the virtual brick. */
class OnTheBrickTest {
    @TempDir static Path folder;
    @AutoClose private static CompiledTests tests;
    private static CaseResults cases;

    @BeforeAll
    static void runTheCases() throws Exception {
        tests = CompiledTests.of(folder, Map.of("cases.BrickCases", CompiledTests.resource("BrickCases.java.txt")));
        cases = new CaseResults(tests.run(true, "cases.BrickCases").testEvents());
    }

    @Test
    void bodiesThatHoldPass() {
        cases.assertPassed("timePasses", "openedBefore", "threadsOfItsOwn", "staticsAreItsOwn", "staticsAreItsOwnAgain",
                "turns#1", "turns#2", "expectsAnException", "leavesAThreadBehind", "seesTheOuterInstance");
    }

    @Test
    void aFailedAssertionSurfacesWithMessageAndLine() {
        Throwable failure = cases.failure("failsWithItsOwnMessage");
        assertThat(failure).isInstanceOf(AssertionError.class).hasMessage("sum ==> expected: <4> but was: <5>");
        assertThat(failure.getStackTrace()).anySatisfy(frame -> {
            assertThat(frame.getMethodName()).isEqualTo("failsWithItsOwnMessage");
            assertThat(frame.getFileName()).isEqualTo("BrickCases.java");
            assertThat(frame.getLineNumber()).isEqualTo(lineOf("sum"));
        });
    }

    private static int lineOf(String text) {
        return (int) CompiledTests.resource("BrickCases.java.txt").lines().takeWhile(line -> !line.contains("\"" + text
                + "\"")).count() + 1;
    }

    @Test
    void anExceptionSurfacesAsItIs() {
        assertThat(cases.failure("throwsItsOwnException")).isInstanceOf(UnsupportedOperationException.class)
                .hasMessage("not today");
    }

    @Test
    void aFailureTellsTheSimulation() {
        assertThat(cases.failure("failsWithItsOwnMessage").getSuppressed()).singleElement()
                .satisfies(story -> assertThat(story.toString())
                .contains("simulation of cases.BrickCases in pen", "seed 1", "failsWithItsOwnMessage",
                "brickless replay ").containsPattern("after 2\\.[56]\\d*"
                + " simulated seconds|after [23](\\.\\d+)? simulated seconds"));
    }

    @Test
    void aTestThatDoesNotEndFailsAtTheLimit() {
        assertThat(cases.failure("neverEnds")).isInstanceOf(AssertionError.class)
                .hasMessageContaining("did not end within 20 simulated seconds");
    }

    @Test
    void aTestThatExitsFails() {
        assertThat(cases.failure("exits")).hasMessageContaining("ended the program with status 3");
    }

    @Test
    void aTestThatLocksUpFailsWithADump() {
        assertThat(cases.failure("locksUp")).hasMessageContaining("deadlock").hasMessageContaining("\"main\"");
    }

    @Test
    void aTestOnTheBrickCannotHoldTheSimulation() {
        assertThat(cases.failure("wantsTheSimulation"))
                .hasMessageContaining("is inside the simulation and cannot hold it");
    }
}
