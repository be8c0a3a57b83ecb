package brickless.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Files of the user on the brick, and files of the program for the user, from the command line. */
class FilesOptionTest {
    /** Drives as long as its file says, and adds to it: a run that saw another's file would differ. */
    private static final String LEARNER = """
            import java.io.*;
            import java.nio.file.*;
            import lejos.hardware.motor.Motor;
            import lejos.utility.Delay;
            public class Learner {
                public static void main(String[] args) throws IOException {
                    Path file = Paths.get("learned.txt");
                    int times = Files.exists(file) ? Files.readAllLines(file).size() : 0;
                    Motor.B.forward();
                    Delay.msDelay(200 + 200 * times);
                    Files.write(file, "again\\n".getBytes(), StandardOpenOption.CREATE, StandardOpenOption.APPEND);
                    System.out.println("learned " + (times + 1));
                }
            }
            """;

    @TempDir Path folder;
    private Path program;

    @BeforeEach
    void writeTheProgram() throws IOException {
        program = Files.writeString(Files.createDirectories(folder.resolve("program")).resolve("Learner.java"),
                LEARNER);
    }

    private CommandLineRun run(Object... more) {
        return CommandLineRun.of(Stream.concat(Stream.of("run", program, "--out", folder.resolve("out")),
                Stream.of(more)).toArray());
    }

    @Test
    void whatAProgramWritesIsToldAndKept() {
        for (int i = 0; i < 2; i++) {
            CommandLineRun run = run();
            assertThat(run.status()).isZero();
            assertThat(run.out()).contains("learned 1").contains("files written: learned.txt (6 bytes)");
            assertThat(folder.resolve("out/files/learned.txt")).hasContent("again");
            assertThat(folder.resolve("program")).isDirectoryNotContaining("glob:**.txt");
        }
    }

    @Test
    void aFolderOfFilesIsPutOnTheBrick() throws IOException {
        Path before = Files.createDirectories(folder.resolve("before"));
        Files.writeString(before.resolve("learned.txt"), "once\ntwice\n");
        assertThat(run("--files", before).out()).contains("learned 3");
        assertThat(before.resolve("learned.txt")).hasContent("once\ntwice");
        assertThat(folder.resolve("out/files/learned.txt")).hasContent("once\ntwice\nagain");
    }

    @Test
    void whatLiesBesideTheProgramIsOnTheBrick() throws IOException {
        Path beside = Files.writeString(program.resolveSibling("learned.txt"), "once\n");
        assertThat(run().out()).contains("learned 2");
        assertThat(beside).hasContent("once");
    }

    @Test
    void aMissingFolderIsOneLineAndStatusTwo() throws IOException {
        CommandLineRun run = run("--files", folder.resolve("absent"));
        assertThat(run.status()).isEqualTo(2);
        assertThat(run.err().lines()).containsExactly("brickless run: --files " + folder.resolve("absent")
                + ": no such folder");
        assertThat(folder.resolve("out")).doesNotExist();
        Path file = Files.writeString(folder.resolve("file"), "x");
        assertThat(run("--files", file).err().lines()).containsExactly("brickless run: --files " + file
                + ": is no folder");
    }

    @Test
    void theFolderOfTheRunIsRefused() throws IOException {
        Path own = Files.createDirectories(folder.resolve("out/files"));
        CommandLineRun run = run("--files", own);
        assertThat(run.status()).isEqualTo(2);
        assertThat(run.err().lines()).hasSize(1).first().asString().contains("lies in the folder that this run writes");
    }

    @Test
    void runsOfASweepDoNotSeeEachOther() throws IOException {
        String[] lines = new String[3];
        for (int jobs = 1; jobs <= 2; jobs++) {
            CommandLineRun sweep = CommandLineRun.of("sweep", program, "--seeds", "1..6", "--ideal", "--jobs", jobs,
                    "--for", "3s");
            assertThat(sweep.status()).isZero();
            lines[jobs] = sweep.out();
        }
        assertThat(lines[2]).isEqualTo(lines[1]);
        assertThat(lines[1].lines()).hasSize(6).allMatch(line -> line.contains("\"simulatedSeconds\":0.2"));
        assertThat(Path.of("learned.txt")).doesNotExist();
        assertThat(folder.resolve("program")).isDirectoryNotContaining("glob:**.txt");
    }

    @Test
    void explorationsDoNotSeeEachOther() {
        CommandLineRun explored = CommandLineRun.of("explore", program, "--schedules", "5", "--for", "3s");
        assertThat(explored.status()).as(explored.toString()).isZero();
        assertThat(Path.of("learned.txt")).doesNotExist();
    }

    @Test
    void theCommandThatRepeatsAFailureNamesTheFolder() throws IOException {
        Files.writeString(program, LEARNER.replace("System.out.println(", "throw new IOException("));
        Path before = Files.createDirectories(folder.resolve("before"));
        assertThat(run("--files", before).err()).contains("run it again: brickless run " + program + " --files "
                + before);
    }
}
