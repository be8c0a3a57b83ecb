package brickless.junit;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.platform.testkit.engine.EngineExecutionResults;

/** Simulations and runs as parameters of tests, and what a failing test tells. */
class SimulatedTest {
    @TempDir static Path folder;
    @AutoClose private static CompiledTests tests;
    private static EngineExecutionResults results;
    private static CaseResults cases;

    @BeforeAll
    static void runTheCases() throws Exception {
        tests = CompiledTests.of(folder, Map.of("cases.RunCases", CompiledTests.resource("RunCases.java.txt")));
        results = tests.run(true, "cases.RunCases");
        cases = new CaseResults(results.allEvents());
    }

    @Test
    void testsThatHoldPass() {
        cases.assertPassed("oneSimulationPerTest", "methodBeforeClass", "filesOfTheUser", "freshBrick",
                "inlineWorld", "inlineRobot", "seeds#1", "seeds#2", "seeds#3", "seeds#4", "seedByParameter#1",
                "seedByParameter#2", "severalRuns", "activeBehaviour");
    }

    @Test
    void seedsAreInTheNamesOfInvocations() {
        assertThat(results.testEvents().started().map(event -> event.getTestDescriptor().getDisplayName()))
                .contains("seed 1", "seed 7");
    }

    @Test
    void aFailingTestTellsOutcomeTimeSeedFolderAndReplay() {
        Throwable failure = cases.failure("failsWhileRunning");
        assertThat(failure).isInstanceOf(AssertionError.class).hasMessageContaining("nothing of the kind");
        Path trace = tests.runs().resolve("cases.RunCases.failsWhileRunning");
        assertThat(failure.getSuppressed()).singleElement()
                .hasToString("simulation of explorer.Explorer in pen with educator\n"
                + "  outcome  still running after 1.5 simulated seconds, seed 5\n"
                + "  trace    " + trace + "\n"
                + "  replay   brickless replay " + trace);
        assertThat(trace.resolve("trace.jsonl")).isNotEmptyFile();
    }

    @Test
    void everyRunHasItsOwnFolder() throws IOException {
        try (Stream<Path> folders = Files.list(tests.runs())) {
            assertThat(new TreeSet<>(folders.map(path -> path.getFileName().toString()).toList()))
                    .contains("cases.RunCases.severalRuns",
                    "cases.RunCases.severalRuns-2", "cases.RunCases.inlineWorld");
        }
        try (Stream<Path> files = Files.walk(tests.runs())) {
            assertThat(files.filter(file -> file.toString().endsWith(".part")))
                    .as("files of runs that were not finished").isEmpty();
        }
    }

    @Test
    void oneAfterTheOtherTheRunsAreTheSame(@TempDir Path other) throws Exception {
        try (CompiledTests alone = CompiledTests.of(other, Map.of("cases.RunCases",
                CompiledTests.resource("RunCases.java.txt")))) {
            alone.run(false, "cases.RunCases");
            for (String run : List.of("methodBeforeClass", "inlineWorld", "severalRuns-2", "expectsInVain",
                    "expectsAlways", "expectsNever")) {
                Path trace = Path.of("cases.RunCases." + run, "trace.jsonl");
                assertThat(alone.runs().resolve(trace)).as(run).hasSameBinaryContentAs(tests.runs().resolve(trace));
            }
        }
    }

    @Test
    void anExpectationInVainTellsTimeAndValue() {
        assertThat(cases.failure("expectsInVain").getMessage())
                .matches("(?s)\\nExpecting x in metres\\n  eventually: be beyond 1\\.9\\n"
                + "  within 2 simulated seconds from 0 s on\\nbut at 2 simulated seconds it was\\n  \\d\\.\\d+\\n"
                + "seen on the way: smallest 0\\.3\\d* at 0 s, largest \\d\\.\\d+ at [\\d.]+ s");
    }

    @Test
    void anExpectationThatBreaksTellsWhen() {
        assertThat(cases.failure("expectsAlways").getMessage())
                .matches("(?s)\\nExpecting way in metres\\n  always: stay below 0\\.3\\n"
                + "but at \\d\\.\\d+ simulated seconds it was\\n  0\\.30\\d*\\n.*");
    }

    @Test
    void whatNeverMayHappenIsToldWhenItDoes() {
        assertThat(cases.failure("expectsNever").getMessage())
                .matches("(?s)\\nExpecting the run\\n  never: turns away from a wall\\n"
                + "  within 20 simulated seconds from 0 s on\\nbut at \\d+(\\.\\d+)? simulated seconds it did");
    }

    @Test
    void anUnknownWorldIsToldInOneLine() {
        assertThat(cases.failure("unknownWorld").getMessage()).contains("no-such-world: no such world");
    }

    @Test
    void seedsOutOfOrderAreRefused() {
        assertThat(cases.failure("badSeeds")).hasMessageContaining("'5..1' is empty");
    }
}
