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
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** Every row of the compatibility tables names tests or programs that tests run, and they are there. */
class DocumentedTestsTest {
    private static final Path HOME = Path.of(System.getProperty("brickless.home"));
    private static final Pattern QUOTED = Pattern.compile("`([^`]*)`");

    private static List<String> rows;
    private static Map<String, String> sources;

    @BeforeAll
    static void read() throws IOException {
        sources = testSources();
        rows = Files.readAllLines(HOME.resolve("sim/docs/COMPATIBILITY.md")).stream()
                .filter(line -> line.startsWith("|") && !line.startsWith("|--") && !line.endsWith("| test |")).toList();
    }

    /** What the last cell names: "Type.method", also where a name goes on with the type before. */
    private static List<String> named(String row) {
        String[] cells = row.split("\\|");
        Matcher quoted = QUOTED.matcher(cells[cells.length - 1]);
        List<String> names = new ArrayList<>();
        String type = null;
        while (quoted.find()) {
            String[] name = quoted.group(1).split("\\.");
            type = name[0].endsWith("Test") ? name[0] : type;
            if (type != null) {
                names.add(type + "." + name[name.length - 1]);
            }
        }
        return names;
    }

    private static boolean exists(String name) {
        String type = name.substring(0, name.indexOf('.'));
        String method = name.substring(name.indexOf('.') + 1);
        return sources.containsKey(type) && (method.equals(type) || sources.get(type).contains(" " + method + "(")
                || sources.containsKey(method) && sources.get(method).startsWith("package programs."));
    }

    @Test
    void theTestsOfTheCompatibilityTablesExist() {
        List<String> names = rows.stream().flatMap(row -> named(row).stream()).toList();
        assertThat(names).hasSizeGreaterThan(100);
        assertThat(names.stream().filter(name -> !exists(name))).isEmpty();
    }

    @Test
    void everyRowOfTheCompatibilityTablesNamesATest() {
        assertThat(rows).hasSizeGreaterThan(100);
        assertThat(rows.stream().filter(row -> named(row).isEmpty())).isEmpty();
    }

    private static Map<String, String> testSources() throws IOException {
        Map<String, String> sources = new HashMap<>();
        try (Stream<Path> files = Files.walk(HOME.resolve("src/test/java"))) {
            for (Path file : files.filter(each -> each.toString().endsWith(".java")).toList()) {
                sources.put(file.getFileName().toString().replace(".java", ""), Files.readString(file));
            }
        }
        return sources;
    }
}
