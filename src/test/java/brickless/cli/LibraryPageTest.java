package brickless.cli;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.simulation.Library;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

/** {@code sim/docs/LIBRARY.md} shows every world and robot, and its commands do what it says. */
class LibraryPageTest {
    private static final Path HOME = Path.of(System.getProperty("brickless.home"));
    private static final Pattern COMMAND = Pattern.compile("`brickless run (sim/[^`]*)`");

    @TempDir Path folder;

    private static String page() throws IOException {
        return Files.readString(HOME.resolve("sim/docs/LIBRARY.md"));
    }

    /** One test per command; the line it stands in says so if its exit status is to be 1. */
    @TestFactory
    Stream<DynamicTest> everyCommandSucceedsOrFailsAsThePageSays() throws IOException {
        List<DynamicTest> tests = new ArrayList<>();
        for (String line : page().lines().toList()) {
            for (String part : line.split("(?<=`)<br>and ")) {
                Matcher command = COMMAND.matcher(part);
                while (command.find()) {
                    String words = command.group(1);
                    int status = part.contains("exit status 1") ? 1 : 0;
                    tests.add(DynamicTest.dynamicTest(words, () -> exits(words, status)));
                }
            }
        }
        assertThat(tests).hasSize(14);
        return tests.stream();
    }

    private void exits(String command, int status) {
        List<Object> words = new ArrayList<>(List.of("run"));
        Arrays.stream(command.split(" ")).map(word -> word.startsWith("sim/") ? HOME.resolve(word).toString() : word)
                .forEach(words::add);
        words.addAll(List.of("--out", folder.resolve("out")));
        CommandLineRun run = CommandLineRun.of(words.toArray());
        assertThat(run.status()).as(run.out() + run.err()).isEqualTo(status);
        assertThat(run.err()).contains(status == 1 ? "fell: a wheel of " : "");
        assertThat(folder.resolve("out/path.svg")).isRegularFile();
    }

    @Test
    void everyWorldAndRobotIsShown() throws IOException {
        String page = page();
        Stream<String> worlds = Library.WORLDS.stream().map(name -> "worlds/" + name);
        Stream<String> robots = Library.ROBOTS.stream().map(name -> "robots/" + name);
        Stream.concat(worlds, robots).forEach(name -> {
            assertThat(page).contains("](images/" + name + ".png)");
            assertThat(HOME.resolve("sim/docs/images/" + name + ".png")).isRegularFile();
        });
        Library.WORLDS.forEach(name -> assertThat(page)
                .containsPattern("`brickless run [^`]*--world " + name + "[ `]|" + name + "\\*\\* \\(the default\\)"));
    }
}
