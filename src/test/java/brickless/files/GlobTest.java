package brickless.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.FileSystems;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.PatternSyntaxException;
import org.junit.jupiter.api.Test;

/** Patterns of file names mean what they mean on the host. */
class GlobTest {
    private static final List<String> GLOBS = List.of("*", "*.txt", "a?c", "*.{txt,csv}", "[a-c]*", "[!a-c]*",
            "**.txt", "a/*", "a/**", "{a,b}{1,2}",
            "a,b", "a.b", "\\*", "[*?]", "x+y(z)", "[a-]b", "*}", "$^|");
    private static final List<String> NAMES = List.of("a", "a.txt", "abc", "a/c", "a/b.txt", "x.csv", "d.txt", "b2",
            "a,b", "a.b", "aXb", "*", "?",
            "x+y(z)", "-b", "ab", "a}", "$^|", ".txt");

    private final BrickFiles files = new BrickFiles(0, () -> 0);

    @Test
    void everyPatternMatchesWhatItMatchesOnTheHost() {
        for (int i = 0; i < GLOBS.size() * NAMES.size(); i++) {
            String glob = "glob:" + GLOBS.get(i % GLOBS.size());
            String name = NAMES.get(i / GLOBS.size());
            assertThat(files.fileSystem().getPathMatcher(glob).matches(files.path(name)))
                    .as(i + ": " + glob + " and " + name)
                    .isEqualTo(FileSystems.getDefault().getPathMatcher(glob).matches(Path.of(name)));
        }
    }

    @Test
    void patternsThatAreNotClosedAreRefused() {
        for (String open : List.of("a{b", "a[b", "{a,{b}}")) {
            assertThatThrownBy(() -> files.fileSystem().getPathMatcher("glob:" + open)).as(open)
                    .isInstanceOf(PatternSyntaxException.class);
        }
        assertThatThrownBy(() -> files.fileSystem().getPathMatcher("*.txt"))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> files.fileSystem().getPathMatcher("sql:%"))
                .isInstanceOf(UnsupportedOperationException.class);
    }

    @Test
    void regularExpressionsMatchTheWholePath() {
        assertThat(files.fileSystem().getPathMatcher("regex:a.*").matches(files.path("abc"))).isTrue();
        assertThat(files.fileSystem().getPathMatcher("regex:b").matches(files.path("abc"))).isFalse();
    }
}
