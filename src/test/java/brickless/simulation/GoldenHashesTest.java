package brickless.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.program.ProgramException;
import brickless.world.DescriptionException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * The example programs run today as they ran when {@code hashes.txt} was written: on this machine, JDK and back-end as
 * on any other. A change of behaviour that is meant refreshes the file with {@code ./gradlew test -PupdateGolden}.
 */
class GoldenHashesTest {
    private static final Path FILE = Path.of("src", "test", "resources", "brickless", "golden", "hashes.txt");
    private static final int SECONDS = 15;

    @Test
    void theExamplesRunAsTheyAlwaysDid() throws Exception {
        Path file = Path.of(System.getProperty("brickless.home")).resolve(FILE);
        List<String> today = hashes();
        if (Boolean.getBoolean("brickless.updateGolden")) {
            Files.writeString(file, String.join("\n", today) + "\n");
        }
        assertThat(today).isEqualTo(Files.readAllLines(file));
    }

    /** One line per program: main class, world, seed, hash of the trace. */
    private static List<String> hashes() throws ProgramException, DescriptionException, IOException {
        List<String> lines = new ArrayList<>();
        try (ExamplePrograms programs = ExamplePrograms.compiled()) {
            for (String main : ExamplePrograms.MAINS) {
                String world = ExamplePrograms.worldOf(main);
                Run run = new Simulation(ExamplePrograms.settings(world).limit(Duration.ofSeconds(SECONDS)).build())
                        .start(programs.program(main));
                run.toEnd();
                lines.add(main + " " + world + " " + run.report().seed() + " " + run.report().traceHash());
            }
        }
        return lines;
    }
}
