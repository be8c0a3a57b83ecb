package brickless.junit;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The code in {@code sim/docs/TESTING-YOUR-ROBOT.md} compiles and its tests pass. */
class GuideTest {
    private static final Pattern CODE = Pattern.compile("```java\\n(.*?)```", Pattern.DOTALL);
    /** What the short pieces of the guide stand in. */
    private static final String FRAME = """
            package guide;
            import static org.assertj.core.api.Assertions.assertThat;
            import static org.assertj.core.api.Assertions.within;
            import static org.junit.jupiter.api.Assertions.assertEquals;
            import brickless.junit.*;
            import brickless.simulation.*;
            import java.time.Duration;
            import java.util.Optional;
            import lejos.hardware.motor.Motor;
            import org.junit.jupiter.api.Test;

            @Simulated(world = "pen", robot = "educator")
            class %s {
            %s
            }
            """;

    @TempDir Path folder;

    @Test
    void everyExampleOfTheGuidePasses() throws Exception {
        Map<String, String> sources = sources();
        assertThat(sources).hasSizeGreaterThan(5);
        try (CompiledTests tests = CompiledTests.of(folder, sources)) {
            tests.run(true, sources.keySet().toArray(String[]::new)).testEvents()
                    .assertStatistics(events -> events.started(11).succeeded(11).failed(0).skipped(0));
        }
    }

    private static Map<String, String> sources() throws IOException {
        Map<String, String> sources = new LinkedHashMap<>();
        for (String code : examples()) {
            if (code.startsWith("package ")) {
                String name = code.replaceFirst("(?s)package (\\w+);.*?class (\\w+).*", "$1.$2");
                sources.put(name, code);
            } else {
                String name = "Example" + (sources.size() + 1);
                sources.put("guide." + name, FRAME.formatted(name, code));
            }
        }
        return sources;
    }

    private static List<String> examples() throws IOException {
        String guide = Files.readString(Path.of(System.getProperty("brickless.home"), "sim", "docs",
                "TESTING-YOUR-ROBOT.md"));
        List<String> examples = new ArrayList<>();
        for (Matcher code = CODE.matcher(guide); code.find();) {
            examples.add(code.group(1));
        }
        return examples;
    }
}
