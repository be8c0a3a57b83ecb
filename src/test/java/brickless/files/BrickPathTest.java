package brickless.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.nio.file.ProviderMismatchException;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.function.Function;
import org.junit.jupiter.api.Test;

/** Paths of a brick are put together and taken apart like those of any Linux, of which the host's are one example. */
class BrickPathTest {
    private static final List<String> TEXTS = List.of("", "/", "a", "a/b", "/a", "/a/b/c", "../a", "a/../b", "./a/.",
            "a//b/", "..", "/..", "b",
            "a/b/c", "../../x", "a b.txt", ".hidden");

    private final BrickFiles files = new BrickFiles(0, () -> 0);

    private static String text(Object value) {
        return Objects.toString(value);
    }

    private void sameAsTheHost(String what, Function<Path, Object> question) {
        for (String text : TEXTS) {
            assertThat(text(question.apply(files.path(text)))).as(what + " of '" + text + "'")
                    .isEqualTo(text(question.apply(Path.of(text))));
        }
    }

    @Test
    void theirPartsAreThoseOfTheHostsPaths() {
        sameAsTheHost("text", Path::toString);
        sameAsTheHost("name", Path::getFileName);
        sameAsTheHost("parent", Path::getParent);
        sameAsTheHost("root", Path::getRoot);
        sameAsTheHost("count", Path::getNameCount);
        sameAsTheHost("normal form", Path::normalize);
        sameAsTheHost("absolute", Path::isAbsolute);
        sameAsTheHost("first name", path -> path.getNameCount() == 0 ? "none" : path.getName(0));
        sameAsTheHost("names", path -> String.join(",", (Iterable<String>) () -> {
            List<String> names = new ArrayList<>();
            path.forEach(name -> names.add(name.toString()));
            return names.iterator();
        }));
    }

    @Test
    void pairsBehaveLikePairsOfTheHostsPaths() {
        for (int i = 0; i < TEXTS.size() * TEXTS.size(); i++) {
            String one = TEXTS.get(i % TEXTS.size());
            String two = TEXTS.get(i / TEXTS.size());
            Path brick = files.path(one);
            Path host = Path.of(one);
            String pair = i + ": '" + one + "' and '" + two + "' ";
            assertThat(text(brick.resolve(two))).as(pair + "resolved").isEqualTo(text(host.resolve(two)));
            assertThat(text(brick.resolveSibling(two))).as(pair + "sibling").isEqualTo(text(host.resolveSibling(two)));
            assertThat(brick.startsWith(two)).as(pair + "start").isEqualTo(host.startsWith(two));
            assertThat(brick.endsWith(two)).as(pair + "end").isEqualTo(host.endsWith(two));
            assertThat(brick.equals(files.path(two))).as(pair + "equal").isEqualTo(host.equals(Path.of(two)));
            assertThat(Integer.signum(brick.compareTo(files.path(two)))).as(pair + "order")
                    .isEqualTo(Integer.signum(host.compareTo(Path.of(two))));
        }
    }

    @Test
    void aWayLeadsFromOneNormalPathToAnother() {
        List<String> normal = List.of("/", "/a", "/a/b/c", "/a/x", "/b");
        for (int i = 0; i < normal.size() * normal.size(); i++) {
            String one = normal.get(i % normal.size());
            String two = normal.get(i / normal.size());
            assertThat(text(files.path(one).relativize(files.path(two)))).as(i + ": from " + one + " to " + two)
                    .isEqualTo(text(Path.of(one).relativize(Path.of(two))));
        }
        assertThatThrownBy(() -> files.path("/a").relativize(files.path("b")))
                .isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void relativePathsBeginWhereProgramsLie() {
        assertThat(files.path("a/../b").toAbsolutePath()).hasToString("/home/lejos/programs/a/../b");
        assertThat(files.path("").toAbsolutePath()).hasToString("/home/lejos/programs");
        assertThat(files.path("log one.txt").toUri()).hasToString("file:/home/lejos/programs/log%20one.txt");
    }

    @Test
    void pathsOfTwoBricksDiffer() {
        assertThat(files.path("/a")).isNotEqualTo(new BrickFiles(0, () -> 0).path("/a"));
    }

    @Test
    void pathsOfTheHostAreRefused() {
        assertThatThrownBy(() -> files.path("/a").resolve(Path.of("b"))).isInstanceOf(ProviderMismatchException.class);
    }
}
