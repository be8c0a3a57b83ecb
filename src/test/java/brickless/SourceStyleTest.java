package brickless;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** What all sources look like, as far as a machine can tell. */
class SourceStyleTest {
    private static final Path SOURCES = Path.of(System.getProperty("brickless.home"), "src");
    private static final int LONGEST_LINE = 120;
    private static final Pattern ANNOTATED_METHOD = Pattern.compile(
            " *@(Override|Test|TestFactory|ParameterizedTest|BeforeEach|AfterEach|BeforeAll|AfterAll)\\b.*\\S *\\{");
    private static final Pattern OUTDATED = Pattern.compile("\\b(TODO|FIXME|XXX)\\b");
    private static final Comparator<String> IMPORTS = Comparator
            .comparing((String line) -> !line.startsWith("import static "))
            .thenComparing(line -> line.replace(";", ""));

    private static List<Source> sources;

    /** A file and its lines. */
    private record Source(Path file, List<String> lines) {
        /** Places, as {@code file:line}, of lines that are as they should not be. */
        Stream<String> places(Predicate<String> wrong) {
            return IntStream.range(0, lines.size()).filter(i -> wrong.test(lines.get(i)))
                    .mapToObj(i -> SOURCES.relativize(file) + ":" + (i + 1));
        }
    }

    @BeforeAll
    static void read() throws IOException {
        sources = new ArrayList<>();
        try (Stream<Path> files = Files.walk(SOURCES)) {
            for (Path file : files.filter(each -> each.toString().endsWith(".java")).sorted().toList()) {
                sources.add(new Source(file, Files.readAllLines(file)));
            }
        }
        assertThat(sources).hasSizeGreaterThan(1000);
    }

    private static void assertNone(Predicate<String> wrong) {
        assertThat(sources.stream().flatMap(source -> source.places(wrong))).isEmpty();
    }

    @Test
    void linesAreNotLongerThan120Characters() {
        assertNone(line -> line.length() > LONGEST_LINE);
    }

    @Test
    void linesAreIndentedBySpacesAndEndWithoutThem() {
        assertNone(line -> !line.equals(line.stripTrailing()) || line.strip().length() < line.length()
                && line.substring(0, line.length() - line.stripLeading().length()).contains("\t"));
    }

    @Test
    void annotationsOfMethodsStandOnALineOfTheirOwn() {
        assertNone(line -> ANNOTATED_METHOD.matcher(line).matches());
    }

    @Test
    void nothingIsLeftToDo() {
        assertThat(sources.stream().filter(source -> !source.file().endsWith("SourceStyleTest.java"))
                .flatMap(source -> source.places(line -> OUTDATED.matcher(line).find()))).isEmpty();
    }

    @Test
    void staticImportsComeFirstAndAllAreInAlphabeticalOrder() {
        assertThat(sources).allSatisfy(source -> assertThat(source.lines().stream()
                .filter(line -> line.startsWith("import "))).as(source.file().toString()).isSortedAccordingTo(IMPORTS));
    }
}
