package brickless.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A sweep whose process is killed goes on where it was. */
class SweepKilledTest {
    @TempDir Path folder;

    private static String[] sweep(Path out) {
        return new String[] {"sweep", CommandLineRun.program("square/Square.java").toString(), "--seeds", "1..24",
                "--for", "4s", "--jobs", "2",
            "--out", out.toString()};
    }

    private Process start(Path out) throws IOException {
        List<String> command = new ArrayList<>(
                List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-Djava.awt.headless=true",
                        "-XX:TieredStopAtLevel=1", "-cp", System.getProperty("java.class.path"), "brickless.cli.Main"));
        command.addAll(List.of(sweep(out)));
        return new ProcessBuilder(command).redirectOutput(folder.resolve("out.txt").toFile()).start();
    }

    /** Progress is told every tenth of the way; the process is killed when the first is told. */
    private void killHalfWay(Path out) throws IOException, InterruptedException {
        Process process = start(out);
        try (BufferedReader told = new BufferedReader(
                new InputStreamReader(process.getErrorStream(), StandardCharsets.UTF_8))) {
            assertThat(told.readLine()).matches("\\d+ of 24 runs.*");
            process.destroyForcibly();
        }
        assertThat(process.waitFor()).as("killed, not ended by itself").isEqualTo(128 + 9);
    }

    private static long lines(Path file) throws IOException {
        try (Stream<String> lines = Files.lines(file)) {
            return lines.count();
        }
    }

    @Test
    void theFileEndsAsIfNothingHadHappened() throws IOException, InterruptedException {
        Path killed = folder.resolve("killed.jsonl");
        killHalfWay(killed);
        assertThat(lines(killed)).isBetween(2L, 23L);
        Path whole = folder.resolve("whole.jsonl");
        assertThat(CommandLineRun.of((Object[]) sweep(whole)).status()).isZero();
        CommandLineRun resumed = CommandLineRun.of((Object[]) sweep(killed));
        assertThat(resumed.err()).contains(" of 24 runs are there already");
        assertThat(resumed.status()).isZero();
        assertThat(killed).hasSameBinaryContentAs(whole);
    }
}
