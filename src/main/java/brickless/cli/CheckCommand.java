package brickless.cli;

import brickless.loading.LejosReferences;
import brickless.loading.MainClasses;
import brickless.loading.MissingReference;
import brickless.loading.UnloadableClassError;
import brickless.program.Program;
import brickless.program.ProgramException;
import brickless.simulation.ProgramClasses;
import brickless.simulation.SetupException;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;

/** {@code brickless check}: what a program uses of leJOS that is missing here, found without running it. */
@Command(name = "check", description = "Lists what a program uses of leJOS that is missing here.",
        mixinStandardHelpOptions = true)
final class CheckCommand implements Callable<Integer> {
    private static final String LEJOS = "lejos.";

    @Parameters(index = "0", paramLabel = "PROGRAM",
            description = "Class name, .java or .class file, directory of sources or classes, or jar.")
    private String name;

    @Option(names = {"--classpath", "-cp"}, paramLabel = "PATH",
            description = "Further directories and jars the program needs.")
    private String classPath = "";

    @ParentCommand
    private Main main;

    @Override
    public Integer call() {
        try (Program program = RunOptions.finder(classPath, null).findClasses(name)) {
            return report(missing(new ProgramClasses(program).files()));
        } catch (ProgramException e) {
            return uncompiled(e.getMessage());
        } catch (SetupException | UnloadableClassError e) {
            throw new UsageException(e.getMessage());
        }
    }

    /** Source that uses what is missing does not even compile; the compiler's messages name it then. */
    private int uncompiled(String message) {
        boolean concernsLejos = message.lines()
                .anyMatch(line -> line.contains(": error: ") && line.contains(LEJOS.substring(0, 5)));
        if (!concernsLejos) {
            throw new UsageException(message);
        }
        main.out().println(name + " does not compile with this leJOS API:");
        message.lines().forEach(line -> main.out().println("  " + line));
        return 1;
    }

    private static List<MissingReference> missing(List<byte[]> files) {
        List<byte[]> own = new ArrayList<>();
        Map<String, byte[]> brought = new HashMap<>();
        for (byte[] file : files) {
            String className = MainClasses.nameOf(file).orElse("");
            if (className.startsWith(LEJOS)) {
                brought.put(className.replace('.', '/'), file);
            } else {
                own.add(file);
            }
        }
        return LejosReferences.missing(own, internalName -> ours(internalName, brought.get(internalName)));
    }

    private static byte[] ours(String internalName, byte[] otherwise) {
        try (InputStream in = CheckCommand.class.getClassLoader().getResourceAsStream(internalName + ".class")) {
            return in == null ? otherwise : in.readAllBytes();
        } catch (IOException e) {
            throw new UncheckedIOException("cannot read " + internalName, e);
        }
    }

    private int report(List<MissingReference> missing) {
        Map<String, List<String>> uses = new LinkedHashMap<>();
        List<MissingReference> byLine = new ArrayList<>(missing);
        byLine.sort(Comparator.comparing(MissingReference::owner).thenComparing(MissingReference::member)
                .thenComparing(MissingReference::usedBy).thenComparingInt(MissingReference::line));
        for (MissingReference reference : byLine) {
            uses.computeIfAbsent(MemberText.of(reference), key -> new ArrayList<>())
                    .add(reference.usedBy() + (reference.line() > 0 ? ":" + reference.line() : ""));
        }
        main.out().println(uses.isEmpty() ? name + ": nothing of leJOS is missing"
                : name + " uses " + uses.size() + " of leJOS missing here:");
        uses.forEach((member, places) -> main.out().println("  " + member + "  used by " + String.join(", ", places)));
        return uses.isEmpty() ? 0 : 1;
    }
}
