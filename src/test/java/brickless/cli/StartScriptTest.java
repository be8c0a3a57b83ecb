package brickless.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Which compilers of the JVM the start script asks for; a script that prints its arguments stands for the JVM. */
class StartScriptTest {
    private static final Path SCRIPT = Path.of(System.getProperty("brickless.home"), "src/main/launcher/brickless");
    private static final String ONE = "-XX:TieredStopAtLevel=1";
    private static final String BOTH = "-XX:TieredStopAtLevel=4";

    @TempDir
    private Path folder;
    private Path java;

    @BeforeEach
    void standInForTheJvm() throws IOException {
        java = folder.resolve("java");
        Files.writeString(java, "#!/bin/sh\nprintf '%s\\n' \"$@\"\n");
        assertThat(java.toFile().setExecutable(true)).isTrue();
    }

    private List<String> argumentsOfTheJvm(String commandLine) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of("sh", SCRIPT.toString()));
        command.addAll(List.of(commandLine.split(" ")));
        ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile());
        builder.environment().put("BRICKLESS_JAVA", java.toString());
        builder.environment().remove("BRICKLESS_TIER");
        Process process = builder.redirectErrorStream(true).start();
        String printed = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor()).as(printed).isZero();
        return printed.lines().toList();
    }

    private void drawRobots(int robots) throws IOException {
        Files.writeString(folder.resolve("crowd.svg"), "<g data-robot='r'/>\n".repeat(robots));
    }

    @ParameterizedTest
    @ValueSource(strings = {"run P", "run P --for 60s", "run P --for=99s", "run P --for 500ms", "run P --for 999ms",
            "run P --world absent.svg", "sweep P", "explore P --for 5m"})
    void shortAndManyRunsDoWithoutTheSecondCompiler(String commandLine) throws Exception {
        assertThat(argumentsOfTheJvm(commandLine)).contains(ONE).doesNotContain(BOTH);
    }

    @ParameterizedTest
    @ValueSource(strings = {"run P --for 100s", "run --for=2m P", "run P --for 1h", "view P", "check P", "replay D"})
    void longRunsAndViewsHaveBoth(String commandLine) throws Exception {
        assertThat(argumentsOfTheJvm(commandLine)).contains(BOTH).doesNotContain(ONE);
    }

    @Test
    void manyRobotsAreWorthTheSecondCompiler() throws Exception {
        drawRobots(8);
        assertThat(argumentsOfTheJvm("run P --world crowd.svg")).contains(BOTH);
        assertThat(argumentsOfTheJvm("run P --world=crowd.svg --for 10s")).contains(BOTH);
        drawRobots(7);
        assertThat(argumentsOfTheJvm("run P --world crowd.svg")).contains(ONE);
    }

    @Test
    void argumentsArePassedOnAsTheyAre() throws Exception {
        List<String> arguments = argumentsOfTheJvm("run My$Robot.java --until zone:goal");
        assertThat(arguments).endsWith("brickless.cli.Main", "run", "My$Robot.java", "--until", "zone:goal");
    }
}
