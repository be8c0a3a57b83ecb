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

/** What {@code MODELS.md} names is there: constants, and the tests that show its numbers. */
class DocumentedModelsTest {
    private static final Path HOME = Path.of(System.getProperty("brickless.home"));
    private static final Pattern MEMBER = Pattern.compile("`([A-Z]\\w+)\\.(\\w+)`");
    private static final Pattern QUOTED = Pattern.compile("`(?:(\\w+Test)\\.?)?(\\w*)`");

    private static String document;
    private static Map<String, String> sources;

    @BeforeAll
    static void read() throws IOException {
        document = Files.readString(HOME.resolve("sim/docs/MODELS.md"));
        sources = new HashMap<>();
        try (Stream<Path> files = Files.walk(HOME.resolve("src"))) {
            for (Path file : files.filter(each -> each.toString().endsWith(".java")).toList()) {
                sources.merge(file.getFileName().toString().replace(".java", ""), Files.readString(file),
                        String::concat);
            }
        }
    }

    @Test
    void everyNamedMemberExists() {
        List<String> missing = new ArrayList<>();
        Matcher member = MEMBER.matcher(document);
        while (member.find()) {
            if (!hasWord(member.group(1), member.group(2))) {
                missing.add(member.group());
            }
        }
        assertThat(missing).isEmpty();
    }

    /** In the last section a name without a class goes on with the class before. */
    @Test
    void everyNumberNamesTestsThatExist() {
        List<String> missing = new ArrayList<>();
        int named = 0;
        for (String row : document.substring(document.indexOf("## Where each number is tested")).split("\n")) {
            String type = null;
            Matcher quoted = QUOTED.matcher(row.substring(row.lastIndexOf('|', row.length() - 2) + 1));
            while (quoted.find()) {
                type = quoted.group(1) == null ? type : quoted.group(1);
                named++;
                if (type == null || !hasWord(type, quoted.group(2).isEmpty() ? type : quoted.group(2))) {
                    missing.add(row);
                }
            }
        }
        assertThat(missing).isEmpty();
        assertThat(named).isGreaterThan(50);
    }

    private static boolean hasWord(String type, String word) {
        return Pattern.compile("\\b" + word + "\\b").matcher(sources.getOrDefault(type, "")).find();
    }
}
