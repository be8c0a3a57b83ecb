package brickless;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Every test that the compatibility tables name is there. */
class DocumentedTestsTest {
    private static final Path HOME = Path.of(System.getProperty("brickless.home"));
    private static final Pattern QUOTED = Pattern.compile("`([^`]*)`");

    @Test
    void theTestsOfTheCompatibilityTablesExist() throws IOException {
        Map<String, String> sources = testSources();
        List<String> missing = new ArrayList<>();
        int named = 0;
        for (String row : Files.readAllLines(HOME.resolve("sim/docs/COMPATIBILITY.md"))) {
            String[] cells = row.split("\\|");
            Matcher quoted = QUOTED.matcher(cells.length > 2 ? cells[cells.length - 1] : "");
            String type = null;
            while (quoted.find()) {
                String[] name = quoted.group(1).split("\\.");
                type = name[0].endsWith("Test") ? name[0] : type;
                if (type != null) {
                    named++;
                    String method = name[name.length - 1];
                    boolean found = sources.containsKey(type) && (method.equals(type) || sources.get(type)
                            .contains(" " + method + "("));
                    if (!found) {
                        missing.add(type + "." + method);
                    }
                }
            }
        }
        assertThat(missing).isEmpty();
        assertThat(named).isGreaterThan(100);
    }

    private static Map<String, String> testSources() throws IOException {
        Map<String, String> sources = new HashMap<>();
        try (Stream<Path> files = Files.walk(HOME.resolve("src/test/java"))) {
            for (Path file : files.filter(each -> each.toString().endsWith("Test.java")).toList()) {
                sources.put(file.getFileName().toString().replace(".java", ""), Files.readString(file));
            }
        }
        return sources;
    }
}
