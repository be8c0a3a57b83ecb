package brickless.junit;

import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The first example that users see runs as it is written. */
class ExampleTest {
    @TempDir Path folder;

    @Test
    void theExampleOfTheGuidePasses() throws Exception {
        try (CompiledTests tests = CompiledTests.of(folder, Map.of("bumper.BumperCarTest",
                CompiledTests.resource("BumperCarTest.java.txt")))) {
            tests.run(false, "bumper.BumperCarTest").testEvents().debug().assertStatistics(events -> events.started(2)
                    .succeeded(2));
        }
    }
}
