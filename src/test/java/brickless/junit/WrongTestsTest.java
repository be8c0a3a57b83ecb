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

/** What tests are told that ask for something that cannot be, or whose body does not come back. */
class WrongTestsTest {
    private static final Map<String, TestExecutionResult> RESULTS = new TreeMap<>();

    @TempDir static Path folder;
    private static CompiledTests tests;

    @BeforeAll
    static void runTheCases() throws Exception {
        String[] names = {"WrongCases", "ForgottenCases", "ConstructorCases"};
        Map<String, String> sources = new TreeMap<>();
        for (String name : names) {
            sources.put("cases." + name, CompiledTests.resource(name + ".java.txt"));
        }
        tests = CompiledTests.of(folder, sources);
        tests.run(true, sources.keySet().toArray(String[]::new)).testEvents().finished().stream()
                .forEach(event -> RESULTS.put(event.getTestDescriptor().getDisplayName().replaceAll("\\(.*", ""),
                        event.getRequiredPayload(TestExecutionResult.class)));
    }

    @AfterAll
    static void closeTheCases() throws IOException {
        tests.close();
    }

    private static String message(String test) {
        assertThat(RESULTS).containsKey(test);
        return RESULTS.get(test).getThrowable().orElseThrow(() -> new AssertionError(test + " passed")).getMessage();
    }

    @Test
    void drawingsThatAreMissingAreNamed() {
        assertThat(message("worldFileMissing")).contains("worlds/lost.svg: no such").hasLineCount(1);
        assertThat(message("robotFileMissing")).contains("robots/lost.svg: no such").hasLineCount(1);
    }

    @Test
    void mistakesInInlineDrawingsAreLocated() {
        assertThat(message("worldInvalid")).contains(": world of WrongCases:1: <rect>: width=\"ten\" is not a length")
                .hasLineCount(1);
        assertThat(message("robotInvalid")).contains(": robot of WrongCases:2", "propeller").hasLineCount(1);
    }

    @Test
    void settingsThatAreNoneAreNamed() {
        assertThat(message("buttonsInvalid")).contains("'sometimes' is no button policy; allowed: auto, none");
        assertThat(message("stimuliInvalid")).contains("stimuli of WrongCases:2", "tickle");
        assertThat(message("secondsInvalid")).contains("@Simulated: -1 seconds");
    }

    @Test
    void whatIsNoProgramIsToldSo() {
        assertThat(message("runWithoutProgram")).contains("needs @Simulated(program = ….class)");
        assertThat(message("programWithoutMain")).contains("NoProgram", "main");
        assertThat(message("startsWhatIsNoProgram")).contains("java.lang.String");
    }

    @Test
    void aTestWithoutTheAnnotationIsToldThatNobodyKnowsItsParameter() {
        assertThat(message("asksWithoutTheAnnotation"))
                .contains("No ParameterResolver registered", "brickless.simulation.Simulation");
        assertThat(RESULTS.get("seed 4").getThrowable()).isEmpty();
    }

    @Test
    void constructorsCannotHaveASimulation() {
        assertThat(message("never")).contains("constructors and @BeforeAll methods cannot have one");
    }

    @Test
    void keysAndTimesThatAreNoneAreNamed() {
        assertThat(message("pressesAKeyThatIsNone")).contains("ANY");
        assertThat(message("expectsWithinLessThanNothing")).contains("negative");
    }

    @Test
    void anExpectationBeyondTheEndTellsThatTheRunHadEnded() {
        assertThat(message("waitsBeyondTheEnd")).contains("eventually: be a marathon", "the run had ended: exited")
                .containsPattern("but at \\d+\\.\\d+ simulated seconds");
    }

    @Test
    void bodiesThatDoNotComeBackEndAtTheLimit() {
        assertThat(message("spins")).contains("did not end within 5 simulated seconds");
        assertThat(message("sleepsForEver")).contains("did not end within 5 simulated seconds");
        assertThat(message("exitsWithNothingWrong")).contains("ended the program with status 0 before it returned");
    }

    @Test
    void anExceptionInAThreadOfTheBodyIsNotTheTests() {
        assertThat(RESULTS.get("failsInAThread").getThrowable()).isEmpty();
    }
}
