package brickless.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * {@code brickless sweep}: the same lines in the same order, whatever the number of jobs and however often it was
 * killed.
 */
class SweepCommandTest {
    /** Fails in about half of its runs: the program's random numbers come from the seed. */
    private static final String CHANCE = """
            import lejos.hardware.motor.Motor;
            import lejos.utility.Delay;
            public class Chance {
                public static void main(String[] args) {
                    Motor.B.forward();
                    Motor.C.forward();
                    Delay.msDelay(100 + (int) (Math.random() * 300));
                    System.exit(Math.random() < 0.5 ? 3 : 0);
                }
            }
            """;
    private static final String SEEDS = "1..4,9,7";

    @TempDir Path folder;
    private Path program;

    @BeforeEach
    void writeTheProgram() throws IOException {
        program = Files.writeString(folder.resolve("Chance.java"), CHANCE);
        String home = System.getProperty("brickless.home");
        for (String world : List.of("pen", "line-loop")) {
            Files.copy(Path.of(home, "sim", "worlds", world + ".svg"), folder.resolve(world + ".svg"));
        }
    }

    private CommandLineRun sweep(Object... more) {
        List<Object> words = new ArrayList<>(List.of("sweep", program, "--worlds", folder.resolve("*.svg"), "--seeds",
                SEEDS, "--for", "2s"));
        words.addAll(List.of(more));
        return CommandLineRun.of(words.toArray());
    }

    @Test
    void linesComeInTheOrderOfWorldsAndSeeds() {
        assertThat(sweep().out().lines().map(line ->
                line.replaceFirst(".*\"world\":\"([^\"]*)\".*\"seed\":(\\d+).*", "$1 $2"))).containsExactly(
                "line-loop 1", "line-loop 2", "line-loop 3", "line-loop 4", "line-loop 9", "line-loop 7",
                "pen 1", "pen 2", "pen 3", "pen 4", "pen 9", "pen 7");
    }

    @Test
    void worldsCanBeNamedOneByOneOrByPatternsWithBraces() {
        CommandLineRun run = CommandLineRun.of("sweep", program, "--worlds", "pen", "--worlds",
                folder.resolve("{line-loop,pen}.svg"), "--for", "1s");
        assertThat(run.out().lines().map(line -> line.replaceFirst(".*\"world\":\"([^\"]*)\".*", "$1")))
                .containsExactly("pen", "line-loop", "pen");
    }

    @Test
    void theNumberOfJobsChangesNothing() {
        String one = sweep("--jobs", 1).out();
        assertThat(one.lines()).hasSize(12);
        assertThat(sweep("--jobs", 3).out()).isEqualTo(one);
        assertThat(sweep("--jobs", 2, "--backend", "threads").out()).isEqualTo(one);
    }

    @Test
    void aLineTellsNothingOfTheMachine() {
        assertThat(sweep().out().lines().findFirst().orElseThrow())
                .contains("\"passed\":", "\"traceHash\":", "\"outcome\":\"exited\"")
                .doesNotContain("wallSeconds").doesNotContain("realTimeFactor").doesNotContain("backend")
                .doesNotContain("jdk");
    }

    @Test
    void aFailedRunFailsTheSweep() {
        CommandLineRun run = sweep();
        assertThat(run.out()).contains("\"exitStatus\":3,\"passed\":false")
                .contains("\"exitStatus\":0,\"passed\":true");
        assertThat(run.status()).isEqualTo(1);
    }

    @Test
    void aSweepWithoutFailureSucceeds() {
        assertThat(CommandLineRun.of("sweep", CommandLineRun.program("square/Square.java"), "--seeds", "5", "--for",
                "1s").status()).isZero();
    }

    @Test
    void cutAnywhereAndContinuedTheFileEndsTheSame() throws IOException {
        Path whole = folder.resolve("whole.jsonl");
        assertThat(sweep("--out", whole).status()).isEqualTo(1);
        byte[] bytes = Files.readAllBytes(whole);
        for (int part = 0; part <= 4; part++) {
            Path cut = folder.resolve("cut" + part + ".jsonl");
            Files.write(cut, Arrays.copyOf(bytes, bytes.length * part / 4 - (part == 3 ? 1 : 0)));
            CommandLineRun run = sweep("--out", cut, "--jobs", 2);
            assertThat(cut).as("continued after %d quarters", part).hasBinaryContent(bytes);
            assertThat(run.status()).as("failures found count too").isEqualTo(1);
        }
    }

    @Test
    void whatIsThereIsNotRunAgain() throws IOException {
        Path out = folder.resolve("out.jsonl");
        sweep("--out", out);
        List<String> lines = new ArrayList<>(Files.readAllLines(out));
        lines.set(0, lines.get(0).replace("\"collisions\":0", "\"collisions\":777"));
        Files.write(out, lines);
        assertThat(sweep("--out", out).err()).startsWith("12 of 12 runs are there already");
        assertThat(out).content().contains("\"collisions\":777");
    }

    @Test
    void aFileOfAnotherSweepIsLeftAlone() throws IOException {
        Path out = folder.resolve("out.jsonl");
        sweep("--out", out);
        byte[] before = Files.readAllBytes(out);
        CommandLineRun otherSeeds = CommandLineRun.of("sweep", program, "--worlds", folder.resolve("*.svg"), "--seeds",
                "2..9", "--for", "2s", "--out", out);
        assertThat(otherSeeds.status()).isEqualTo(2);
        assertThat(otherSeeds.err()).contains("out.jsonl:1: is of world line-loop and seed 1, not of line-loop and 2");
        Files.writeString(program, CHANCE.replace("300", "301"));
        assertThat(sweep("--out", out).err())
                .contains("out.jsonl:12: was made by another program or with other settings");
        Files.writeString(out, "no json\n", StandardOpenOption.TRUNCATE_EXISTING);
        assertThat(sweep("--out", out).err()).contains("out.jsonl:1: is no JSON object");
        Files.writeString(out, "my diary");
        assertThat(sweep("--out", out).err()).contains("out.jsonl:1: is no half-written line of this sweep");
        assertThat(out).hasContent("my diary");
        Files.write(out, before);
        assertThat(sweep("--out", out, "--jobs", "0").status()).isEqualTo(2);
        assertThat(out).hasBinaryContent(before);
    }

    @Test
    void aFileThatCannotBeWrittenIsRefused() throws IOException {
        assertThat(sweep("--out", folder).err()).contains("cannot be written").hasLineCount(1);
        Path busy = folder.resolve("busy.jsonl");
        try (FileChannel other = FileChannel.open(busy, StandardOpenOption.CREATE, StandardOpenOption.WRITE);
                FileLock lock = other.lock()) {
            CommandLineRun run = sweep("--out", busy);
            assertThat(run.err()).contains("busy.jsonl: another sweep is writing it").hasLineCount(1);
            assertThat(run.status()).isEqualTo(2);
        }
    }

    @Test
    void progressIsTold() {
        assertThat(sweep().err().lines().toList()).last().asString().startsWith("12 of 12 runs, ").contains(" failed");
    }

    @Test
    void worldsAndSeedsThatAreNoneAreRefused() {
        assertThat(CommandLineRun.of("sweep", program, "--worlds", folder.resolve("*.png")).err())
                .contains("*.png: no such files");
        assertThat(CommandLineRun.of("sweep", program, "--worlds", "nowhere").err()).contains("nowhere: no such world");
        for (String seeds : List.of("", "a", "1..", "5..1", "1...3", "1,,2")) {
            CommandLineRun run = CommandLineRun.of("sweep", program, "--seeds", seeds);
            assertThat(run.status()).as(seeds).isEqualTo(2);
            assertThat(run.err()).as(seeds).contains("--seeds");
        }
    }
}
