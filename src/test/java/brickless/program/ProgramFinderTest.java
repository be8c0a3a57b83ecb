package brickless.program;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What the finder makes of names; how programs run is tested through the command line. */
class ProgramFinderTest {
    @TempDir Path folder;

    private Program find(String name) throws ProgramException {
        return new ProgramFinder(folder, List.of(), Optional.empty()).find(name);
    }


    @Test
    void closingAProgramRemovesWhatWasCompiled() throws Exception {
        Files.writeString(folder.resolve("Idle.java"), "class Idle { public static void main(String[] a) { } }");
        Path classes;
        try (Program program = find("Idle.java")) {
            classes = program.classPath().get(0);
            assertThat(program.mainClass()).isEqualTo("Idle");
            assertThat(classes.resolve("Idle.class")).exists();
        }
        assertThat(classes).doesNotExist();
    }

    @Test
    void theMainClassOfASourceIsItsOwnEvenBesideOthers() throws Exception {
        Files.createDirectories(folder.resolve("src/a/b"));
        Files.writeString(folder.resolve("src/a/b/Two.java"),
                "package a.b; public class Two { public static void main(String[] a) { One.main(a); } }");
        Files.writeString(folder.resolve("src/a/b/One.java"),
                "package a.b; public class One { public static void main(String[] a) { } }");
        try (Program program = find("src/a/b/Two.java")) {
            assertThat(program.mainClass()).isEqualTo("a.b.Two");
            assertThat(program.simpleName()).isEqualTo("Two");
        }
    }

    @Test
    void compilersMessagesAreLimitedAndInOrder() throws IOException {
        StringBuilder source = new StringBuilder("class Broken {\n");
        for (int i = 0; i < 15; i++) {
            source.append("    int field").append(i).append(" = missing").append(i).append(";\n");
        }
        Files.writeString(folder.resolve("Broken.java"), source.append("}\n"));
        assertThatThrownBy(() -> find("Broken.java")).isInstanceOf(ProgramException.class).satisfies(failure -> {
            List<String> lines = failure.getMessage().lines().toList();
            assertThat(lines).hasSize(11);
            assertThat(lines.get(0)).contains("Broken.java:2: error: cannot find symbol").contains("missing0");
            assertThat(lines.get(10)).isEqualTo("\u2026 and 5 more errors");
        });
    }
}
