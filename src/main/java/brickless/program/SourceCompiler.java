package brickless.program;

import java.io.IOException;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.tools.Diagnostic;
import javax.tools.DiagnosticCollector;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.StandardJavaFileManager;
import javax.tools.StandardLocation;
import javax.tools.ToolProvider;

/**
 * Compiles leJOS programs with the JDK's compiler, against Brickless' own {@code lejos} classes.
 *
 * <p>Java 8 rules are tried first, because that is what leJOS programs were written for (there {@code yield()} is still
 * a method call) and because the resulting bytecode is the same on every JDK; programs that need newer Java are
 * compiled by the JDK's own rules.
 */
final class SourceCompiler {
    private static final Pattern PACKAGE = Pattern.compile("^\\s*package\\s+([\\w.]+)\\s*;", Pattern.MULTILINE);
    private static final int MESSAGES_SHOWN = 10;

    private final List<Path> classPath;

    SourceCompiler(List<Path> classPath) {
        this.classPath = classPath;
    }

    /** Compiles sources, and what they refer to below the roots, into a directory. */
    void compile(List<Path> sources, Set<Path> roots, Path target) throws ProgramException, IOException {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        if (compiler == null) {
            throw new ProgramException(
                    "no Java compiler here: run with a JDK instead of a JRE, or give compiled classes");
        }
        List<Diagnostic<? extends JavaFileObject>> asJava8 = attempt(compiler, sources, roots, target,
                List.of("--release", "8"));
        if (asJava8.isEmpty()) {
            return;
        }
        List<Diagnostic<? extends JavaFileObject>> asNewest = attempt(compiler, sources, roots, target, List.of());
        if (!asNewest.isEmpty()) {
            throw new ProgramException(describe(asNewest.size() <= asJava8.size() ? asNewest : asJava8));
        }
    }

    private List<Diagnostic<? extends JavaFileObject>> attempt(JavaCompiler compiler, List<Path> sources,
            Set<Path> roots, Path target, List<String> rules) throws IOException {
        DiagnosticCollector<JavaFileObject> messages = new DiagnosticCollector<>();
        try (StandardJavaFileManager files = compiler.getStandardFileManager(messages, Locale.ROOT, null)) {
            files.setLocationFromPaths(StandardLocation.CLASS_OUTPUT, List.of(target));
            files.setLocationFromPaths(StandardLocation.SOURCE_PATH, roots);
            List<Path> libraries = new ArrayList<>(classPath);
            for (String entry : System.getProperty("java.class.path").split(java.io.File.pathSeparator)) {
                libraries.add(Path.of(entry));
            }
            files.setLocationFromPaths(StandardLocation.CLASS_PATH, libraries);
            List<String> options = new ArrayList<>(List.of("-g", "-nowarn", "-proc:none", "-Xlint:none"));
            options.addAll(rules);
            StringWriter rest = new StringWriter();
            LenientSourceFiles lenient = new LenientSourceFiles(files);
            boolean fine = compiler.getTask(rest, lenient, messages, options, null,
                    lenient.wrap(files.getJavaFileObjectsFromPaths(sources))).call();
            if (fine) {
                return List.of();
            }
        }
        return messages.getDiagnostics().stream()
                .filter(message -> message.getKind() == Diagnostic.Kind.ERROR).toList();
    }

    private static String describe(List<Diagnostic<? extends JavaFileObject>> errors) {
        StringBuilder text = new StringBuilder();
        for (Diagnostic<? extends JavaFileObject> error : errors.subList(0, Math.min(MESSAGES_SHOWN, errors.size()))) {
            if (error.getSource() != null) {
                text.append(shortest(Path.of(error.getSource().toUri()))).append(':').append(error.getLineNumber())
                        .append(": ");
            }
            text.append("error: ").append(error.getMessage(Locale.ROOT).replaceAll("\\R\\s*", "; ")).append('\n');
        }
        if (errors.size() > MESSAGES_SHOWN) {
            text.append("… and ").append(errors.size() - MESSAGES_SHOWN).append(" more errors\n");
        }
        return text.toString().stripTrailing();
    }

    private static Path shortest(Path file) {
        Path here = Path.of("").toAbsolutePath();
        return file.startsWith(here) ? here.relativize(file) : file;
    }

    /** The directories that the packages of the sources hang from, in order. */
    static Set<Path> rootsOf(List<Path> sources) throws IOException {
        Set<Path> roots = new LinkedHashSet<>();
        for (Path source : sources) {
            Path root = source.toAbsolutePath().normalize().getParent();
            String packageName = packageOf(source);
            if (!packageName.isEmpty()) {
                Path below = Path.of(packageName.replace('.', '/'));
                if (root.endsWith(below)) {
                    for (int i = 0; i < below.getNameCount(); i++) {
                        root = root.getParent();
                    }
                }
            }
            roots.add(root);
        }
        return roots;
    }

    /** The package a source file declares, empty for none. */
    static String packageOf(Path source) throws IOException {
        Matcher matcher = PACKAGE.matcher(LenientSourceFiles.decode(Files.readAllBytes(source)));
        return matcher.find() ? matcher.group(1) : "";
    }
}
