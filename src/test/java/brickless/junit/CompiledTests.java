package brickless.junit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.platform.engine.discovery.DiscoverySelectors.selectClass;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import javax.tools.DiagnosticCollector;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.StandardJavaFileManager;
import javax.tools.StandardLocation;
import javax.tools.ToolProvider;
import org.junit.platform.testkit.engine.EngineExecutionResults;
import org.junit.platform.testkit.engine.EngineTestKit;

/**
 * Tests as a user would have them: compiled apart from ours, on a class path with the example programs, and run by
 * JUnit.
 */
final class CompiledTests implements AutoCloseable {
    private final Path folder;
    private final URLClassLoader loader;

    private CompiledTests(Path folder, URLClassLoader loader) {
        this.folder = folder;
        this.loader = loader;
    }

    /** Compiles sources, by class name, together with the example programs. */
    static CompiledTests of(Path folder, Map<String, String> sources) throws IOException {
        List<Path> files = new ArrayList<>(programs());
        for (Map.Entry<String, String> source : sources.entrySet()) {
            Path file = folder.resolve("src").resolve(source.getKey().replace('.', '/') + ".java");
            Files.createDirectories(file.getParent());
            files.add(Files.writeString(file, source.getValue()));
        }
        Path classes = Files.createDirectories(folder.resolve("classes"));
        compile(files, classes);
        URLClassLoader loader = new URLClassLoader(new URL[] {classes.toUri().toURL()},
                CompiledTests.class.getClassLoader());
        return new CompiledTests(folder, loader);
    }

    /** Text of a fixture in the test resources. */
    static String resource(String name) {
        try (InputStream in = CompiledTests.class.getResourceAsStream(name)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static List<Path> programs() throws IOException {
        try (Stream<Path> files = Files.walk(Path.of(System.getProperty("brickless.home"), "sim", "programs"))) {
            return files.filter(file -> file.toString().endsWith(".java")).sorted().toList();
        }
    }

    private static void compile(List<Path> sources, Path target) throws IOException {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        DiagnosticCollector<JavaFileObject> messages = new DiagnosticCollector<>();
        try (StandardJavaFileManager files = compiler.getStandardFileManager(messages, null, null)) {
            files.setLocationFromPaths(StandardLocation.CLASS_OUTPUT, List.of(target));
            boolean fine = compiler.getTask(null, files, messages, List.of("-g", "-parameters", "-proc:none"), null,
                    files.getJavaFileObjectsFromPaths(sources)).call();
            assertThat(fine).as("%s", messages.getDiagnostics()).isTrue();
        }
    }

    /** Runs classes one after the other, or with all their tests at the same time on four threads. */
    EngineExecutionResults run(boolean parallel, String... classNames) throws ClassNotFoundException {
        Thread thread = Thread.currentThread();
        ClassLoader before = thread.getContextClassLoader();
        thread.setContextClassLoader(loader);
        try {
            EngineTestKit.Builder kit = EngineTestKit.engine("junit-jupiter")
                    .configurationParameter(TestFolder.PARAMETER, runs().toString())
                    .configurationParameter("junit.jupiter.execution.parallel.enabled", String.valueOf(parallel))
                    .configurationParameter("junit.jupiter.execution.parallel.mode.default", "concurrent")
                    .configurationParameter("junit.jupiter.execution.parallel.config.strategy", "fixed")
                    .configurationParameter("junit.jupiter.execution.parallel.config.fixed.parallelism", "4");
            for (String name : classNames) {
                kit.selectors(selectClass(loader.loadClass(name)));
            }
            return kit.execute();
        } finally {
            thread.setContextClassLoader(before);
        }
    }

    /** Where the folders of runs are. */
    Path runs() {
        return folder.resolve("simulations");
    }

    @Override
    public void close() throws IOException {
        loader.close();
    }
}
