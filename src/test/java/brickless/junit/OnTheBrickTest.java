package brickless.junit;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.testkit.engine.Event;

/** Tests whose body runs on the virtual brick. */
class OnTheBrickTest {
    @TempDir static Path folder;
    private static CompiledTests tests;
    private static final Map<String, TestExecutionResult> RESULTS = new TreeMap<>();

    @BeforeAll
    static void runTheCases() throws Exception {
        tests = CompiledTests.of(folder, Map.of("cases.BrickCases", CompiledTests.resource("BrickCases.java.txt")));
        tests.run(true, "cases.BrickCases").testEvents().finished().stream().forEach(event -> RESULTS.put(name(event),
                event.getRequiredPayload(TestExecutionResult.class)));
    }

    @AfterAll
    static void closeTheCases() throws IOException {
        tests.close();
    }

    private static String name(Event event) {
        String id = event.getTestDescriptor().getUniqueId().getLastSegment().getValue();
        return id.startsWith("#") ? event.getTestDescriptor().getParent().orElseThrow().getDisplayName()
                .replaceAll("\\(.*", "") + id
                : id.replaceAll("\\(.*", "");
    }

    private static Throwable failure(String name) {
        assertThat(RESULTS).containsKey(name);
        return RESULTS.get(name).getThrowable().orElseThrow(() -> new AssertionError(name + " passed"));
    }

    @Test
    void bodiesThatHoldPass() {
        for (String name : new String[] {"timePasses", "openedBefore", "threadsOfItsOwn", "staticsAreItsOwn",
                "staticsAreItsOwnAgain", "turns#1",
            "turns#2", "expectsAnException", "leavesAThreadBehind", "seesTheOuterInstance"}) {
            assertThat(RESULTS).containsKey(name);
            assertThat(RESULTS.get(name).getThrowable()).as(name).isEmpty();
        }
    }

    @Test
    void aFailedAssertionSurfacesWithMessageAndLine() {
        Throwable failure = failure("failsWithItsOwnMessage");
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
        assertThat(failure("throwsItsOwnException")).isInstanceOf(UnsupportedOperationException.class)
                .hasMessage("not today");
    }

    @Test
    void aFailureTellsTheSimulation() {
        assertThat(failure("failsWithItsOwnMessage").getSuppressed()).singleElement()
                .satisfies(story -> assertThat(story.toString())
                .contains("simulation of cases.BrickCases in pen", "seed 1", "failsWithItsOwnMessage",
                "brickless replay ").containsPattern("after 2\\.[56]\\d*"
                + " simulated seconds|after [23](\\.\\d+)? simulated seconds"));
    }

    @Test
    void aTestThatDoesNotEndFailsAtTheLimit() {
        assertThat(failure("neverEnds")).isInstanceOf(AssertionError.class)
                .hasMessageContaining("did not end within 20 simulated seconds");
    }

    @Test
    void aTestThatExitsFails() {
        assertThat(failure("exits")).hasMessageContaining("ended the program with status 3");
    }

    @Test
    void aTestThatLocksUpFailsWithADump() {
        assertThat(failure("locksUp")).hasMessageContaining("deadlock").hasMessageContaining("\"main\"");
    }

    @Test
    void aTestOnTheBrickCannotHoldTheSimulation() {
        assertThat(failure("wantsTheSimulation")).hasMessageContaining("is inside the simulation and cannot hold it");
    }
}
