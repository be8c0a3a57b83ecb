package brickless.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import brickless.trace.JsonFields;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The benchmarks still run, with so little effort that their numbers mean nothing. */
class BenchTest {
    @TempDir Path folder;

    @ParameterizedTest
    @CsvSource({"bumper, timesWall", "line, timesCpu", "courier, startMillis", "yielders, switchesPerSecond",
            "robots-10, microsPerRobotStep",
            "bare-1, nanosPerStep", "physics-1, nanosPerStep", "physics-100, nanosPerStep",
            "kernel, cpuMillisPerSecond", "compute, sieve",
            "pieces, rayFanNanos", "cold, wallSeconds"})
    void everyKindOfMeasurementGivesItsFigure(String name, String figure) throws Exception {
        assertThat(BenchCase.named(name).measurement().measure(Effort.TRIAL).get(figure)).isNotNaN();
    }

    @Test
    void aCaseInANewJvmEndsUpInTableAndFile() throws Exception {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        Path file = folder.resolve("bench.json");
        String version = String.valueOf(Runtime.version().feature());
        new Bench(new PrintStream(out, true, StandardCharsets.UTF_8), "--cases", "bare-1,physics-1", "--jdks", version,
                "--effort", "trial", "--out", file.toString()).run();
        List<JsonFields> results = JsonFields.parse(Files.readString(file).strip()).objects("results");
        assertThat(results).extracting(result -> result.text("case")).containsExactly("bare-1", "physics-1");
        assertThat(out.toString(StandardCharsets.UTF_8)).contains("timesBare").containsPattern("physics-1 +" + version);
    }

    @Test
    void wrongOptionsAreExplained() {
        assertThatThrownBy(() -> new Bench(System.out, "--cases", "nothing")).hasMessageContaining("bumper")
                .hasMessageContaining("cold");
        assertThatThrownBy(() -> new Bench(System.out, "--effort", "huge"))
                .hasMessageContaining("full, short or trial");
        assertThatThrownBy(() -> new Bench(System.out, "--cases")).hasMessageContaining("value");
    }

    @Test
    void theMedianIsTheMiddleOne() {
        assertThat(Figures.median(3, 100, 1)).isEqualTo(3);
        assertThat(Figures.median(4, 1, 2, 100)).isEqualTo(3);
    }

    @Test
    void figuresSurviveTheWayThroughText() {
        assertThat(Figures.parse(new Figures().put("a", 1.5).put("b", 1234567).json()).values()).containsEntry("a", 1.5)
                .containsEntry("b", 1234567.0);
    }
}
