package brickless.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code brickless replay}: finds or makes the report of a run, and says what a folder lacks. */
class ReplayCommandTest {
    @TempDir Path folder;

    private Path run() {
        Path run = folder.resolve("run");
        assertThat(CommandLineRun.of("run", CommandLineRun.program("square/Square.java"), "--for", "1s", "--out", run)
                .status()).isZero();
        return run;
    }

    @Test
    void theAddressOfTheReportIsPrinted() {
        Path run = run();
        CommandLineRun replay = CommandLineRun.of("replay", run, "--print-path");
        assertThat(replay.out().strip()).isEqualTo(run.resolve("report.html").toUri().toString());
        assertThat(replay.status()).isZero();
    }

    @Test
    void aMissingReportIsMadeAgain() throws IOException {
        Path run = run();
        byte[] first = Files.readAllBytes(run.resolve("report.html"));
        Files.delete(run.resolve("report.html"));
        assertThat(CommandLineRun.of("replay", run, "--print-path").status()).isZero();
        assertThat(run.resolve("report.html")).hasBinaryContent(first);
    }

    @Test
    void aFolderThatIsNoRunIsRefused() throws IOException {
        assertRefused(folder.resolve("nowhere"), "nowhere: no such folder");
        assertRefused(Files.createFile(folder.resolve("file")), "file: is no folder");
        assertRefused(folder, "is not the folder of a run: it holds no trace.jsonl");
        Files.createFile(folder.resolve("trace.jsonl.part"));
        assertRefused(folder, "the run that was writing it did not end");
    }

    @Test
    void aTraceThatIsCutOffIsRefusedWithItsLine() throws IOException {
        Path run = run();
        Files.delete(run.resolve("report.html"));
        byte[] trace = Files.readAllBytes(run.resolve("trace.jsonl"));
        Files.write(run.resolve("trace.jsonl"), Arrays.copyOf(trace, trace.length - 5),
                StandardOpenOption.TRUNCATE_EXISTING);
        assertRefused(run, ": cut off in the middle of a line");
        assertThat(run.resolve("report.html")).doesNotExist();
    }

    @Test
    void aRunWithoutItsDrawingsIsRefused() throws IOException {
        Path run = run();
        Files.delete(run.resolve("report.html"));
        Files.delete(run.resolve("robot.svg"));
        assertRefused(run, "robot.svg: no such file");
    }

    private static void assertRefused(Path run, String why) {
        CommandLineRun replay = CommandLineRun.of("replay", run, "--print-path");
        assertThat(replay.err()).contains(why).hasLineCount(1);
        assertThat(replay.status()).isEqualTo(2);
    }
}
