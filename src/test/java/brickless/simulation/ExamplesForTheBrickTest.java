package brickless.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import lejos.OriginalJar;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * The example programs, and those of the tests, are for a real brick: they need only Java 8 and the published leJOS.
 */
class ExamplesForTheBrickTest {
    @ParameterizedTest
    @CsvSource({"sim/programs, 15", "src/test/java/kit, 20", "src/test/java/programs/students, 14"})
    void programsCompileAgainstThePublishedJar(String folder, int atLeast, @TempDir Path classes) throws IOException {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        StringWriter messages = new StringWriter();
        try (StandardJavaFileManager files = compiler.getStandardFileManager(null, null, null);
                Stream<Path> sources = Files.walk(Path.of(System.getProperty("brickless.home"), folder))) {
            List<File> programs = sources.filter(file -> file.toString().endsWith(".java")).sorted()
                    .map(Path::toFile).toList();
            List<String> options = List.of("--release", "8", "-Xlint:-options", "-nowarn", "-cp",
                    OriginalJar.path().toString(), "-d", classes.toString());
            boolean compiled = compiler.getTask(messages, files, null, options, null,
                    files.getJavaFileObjectsFromFiles(programs)).call();
            assertThat(compiled).as(messages.toString()).isTrue();
            assertThat(programs).hasSizeGreaterThanOrEqualTo(atLeast);
        }
    }
}
