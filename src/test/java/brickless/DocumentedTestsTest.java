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
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Every test that the tables of the documentation name is there, and so is every constant that MODELS.md names. */
class DocumentedTestsTest {
    private static final Path HOME = Path.of(System.getProperty("brickless.home"));
    private static final Pattern QUOTED = Pattern.compile("`([^`]*)`");

    private static final Pattern MEMBER = Pattern.compile("`([A-Z]\\w+)\\.(\\w+)`");

    @ParameterizedTest
    @CsvSource({"COMPATIBILITY.md,100", "MODELS.md,50"})
    void theTestsOfTheTablesExist(String document, int atLeast) throws IOException {
        Map<String, String> sources = sources("src/test/java");
        List<String> missing = new ArrayList<>();
        int named = 0;
        for (String row : Files.readAllLines(HOME.resolve("sim/docs/" + document))) {
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
        assertThat(named).isGreaterThan(atLeast);
    }

    @Test
    void theConstantsOfTheModelsExist() throws IOException {
        Map<String, String> sources = sources("src/test/java");
        sources("src/main/java").forEach((name, source) -> sources.merge(name, source, String::concat));
        Matcher member = MEMBER.matcher(Files.readString(HOME.resolve("sim/docs/MODELS.md")));
        List<String> missing = new ArrayList<>();
        while (member.find()) {
            String source = sources.getOrDefault(member.group(1), "");
            if (!Pattern.compile("\\b" + member.group(2) + "\\b").matcher(source).find()) {
                missing.add(member.group());
            }
        }
        assertThat(missing).isEmpty();
    }

    private static Map<String, String> sources(String folder) throws IOException {
        Map<String, String> sources = new HashMap<>();
        try (Stream<Path> files = Files.walk(HOME.resolve(folder))) {
            for (Path file : files.filter(each -> each.toString().endsWith(".java")).toList()) {
                sources.merge(file.getFileName().toString().replace(".java", ""), Files.readString(file), String::concat);
            }
        }
        return sources;
    }
}
