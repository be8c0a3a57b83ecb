package brickless.program;

import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.tools.Diagnostic;
import javax.tools.JavaFileObject;

/** What the compiler complained about, in its order, and what a person can do about it where that is plain. */
final class CompileErrors {
    private static final int MESSAGES_SHOWN = 10;
    private static final Pattern NO_PACKAGE = Pattern.compile("package ([\\w.]+) does not exist");
    private static final Pattern NO_LEJOS_CLASS =
            Pattern.compile("symbol:\\s+class (\\w+); location: package (lejos[\\w.]*)");
    /** Packages of leJOS for the NXT and the RCX that leJOS EV3 does not have. */
    private static final Pattern OTHER_LEJOS = Pattern.compile(
            "lejos\\.(nxt|util|pc|addon|rcx|charset|geom|subsumption|navigation)\\b.*|josx\\..*");

    private final List<Diagnostic<? extends JavaFileObject>> errors;

    CompileErrors(List<Diagnostic<? extends JavaFileObject>> errors) {
        this.errors = errors;
    }

    int count() {
        return errors.size();
    }

    /** One line for each of the first errors, then one for each thing to be done. */
    String text() {
        StringBuilder text = new StringBuilder();
        errors.stream().limit(MESSAGES_SHOWN).forEach(error -> text.append(line(error)).append('\n'));
        if (errors.size() > MESSAGES_SHOWN) {
            text.append("\u2026 and ").append(errors.size() - MESSAGES_SHOWN).append(" more errors\n");
        }
        advice().forEach(advice -> text.append(advice).append('\n'));
        return text.toString().stripTrailing();
    }

    private static String line(Diagnostic<? extends JavaFileObject> error) {
        String place = error.getSource() == null ? ""
                : shortest(Path.of(error.getSource().toUri())) + ":" + error.getLineNumber() + ": ";
        return place + "error: " + message(error);
    }

    private static String message(Diagnostic<? extends JavaFileObject> error) {
        return error.getMessage(Locale.ROOT).replaceAll("\\R\\s*", "; ");
    }

    private static Path shortest(Path file) {
        Path here = Path.of("").toAbsolutePath();
        return file.startsWith(here) ? here.relativize(file) : file;
    }

    private Set<String> advice() {
        Set<String> advice = new LinkedHashSet<>();
        Set<String> libraries = new TreeSet<>();
        Set<String> absent = new TreeSet<>();
        for (Diagnostic<? extends JavaFileObject> error : errors) {
            Matcher noPackage = NO_PACKAGE.matcher(message(error));
            Matcher noClass = NO_LEJOS_CLASS.matcher(message(error));
            if (noClass.find()) {
                absent.add(noClass.group(2) + "." + noClass.group(1));
            } else if (noPackage.find() && OTHER_LEJOS.matcher(noPackage.group(1)).matches()) {
                advice.add("It is written for leJOS on the NXT or RCX; Brickless runs programs for leJOS EV3,"
                        + " whose packages have other names.");
            } else if (noPackage.reset().find()) {
                (noPackage.group(1).startsWith("lejos.") ? absent : libraries).add(noPackage.group(1));
            }
        }
        if (!absent.isEmpty()) {
            advice.add("Not in Brickless' leJOS: " + String.join(", ", absent)
                    + ". sim/docs/COMPATIBILITY.md lists the classes of leJOS EV3 that are not here.");
        }
        if (!libraries.isEmpty()) {
            advice.add("Not found: " + String.join(", ", libraries) + ". Give the folder with all source files of the"
                    + " program, put the jars of its libraries into it, or name them with --classpath.");
        }
        return advice;
    }
}
