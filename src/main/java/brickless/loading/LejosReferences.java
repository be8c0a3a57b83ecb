package brickless.loading;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import org.objectweb.asm.ClassReader;

/** Compares what a program uses of {@code lejos.**} with what there is. */
public final class LejosReferences {
    private static final String LEJOS = "lejos/";

    private final Function<String, byte[]> available;
    private final Map<String, byte[]> program = new HashMap<>();
    private final Map<String, DeclaredMembers> declared = new HashMap<>();

    private LejosReferences(Function<String, byte[]> available) {
        this.available = available;
    }

    /**
     * Lists what is missing, sorted.
     *
     * @param programClasses class files of the program
     * @param available the class file under an internal name such as {@code lejos/hardware/Sound}, or null
     * @throws UnloadableClassError if a class file of the program is damaged or too new
     */
    public static List<MissingReference> missing(Collection<byte[]> programClasses, Function<String,
            byte[]> available) {
        LejosReferences references = new LejosReferences(available);
        for (byte[] bytes : programClasses) {
            ClassReader reader = ClassFiles.reader(new ClassFile(bytes, "program"), "class of the program");
            references.program.put(reader.getClassName(), bytes);
        }
        Set<MissingReference> missing = new TreeSet<>();
        for (byte[] bytes : programClasses) {
            new ClassReader(bytes).accept(new ReferenceReader(
                    (reference, user, line) -> references.check(reference, user, line, missing)),
                    ClassReader.SKIP_FRAMES);
        }
        return List.copyOf(missing);
    }

    private void check(ReferenceReader.Reference reference, String user, int line, Set<MissingReference> missing) {
        if (!reference.owner().startsWith(LEJOS)) {
            return;
        }
        boolean known = declared(reference.owner()) != null;
        if (!known || !reference.member().isEmpty() && !has(reference.owner(), reference.member(), new HashSet<>())) {
            String member = known ? reference.member() : "";
            missing.add(new MissingReference(reference.owner().replace('/', '.'), member, user.replace('/', '.'),
                    line));
        }
    }

    private boolean has(String owner, String member, Set<String> seen) {
        DeclaredMembers members = declared(owner);
        if (members == null || !seen.add(owner)) {
            return false;
        }
        return members.names().contains(member)
                || members.parents().stream().anyMatch(parent -> has(parent, member, seen));
    }

    private DeclaredMembers declared(String name) {
        return declared.computeIfAbsent(name, key -> {
            byte[] bytes = program.containsKey(key) ? program.get(key) : available.apply(key);
            return bytes != null ? DeclaredMembers.of(bytes) : key.startsWith(LEJOS) ? null : ofJdk(key);
        });
    }

    private static DeclaredMembers ofJdk(String name) {
        try (InputStream in = ClassLoader.getSystemResourceAsStream(name + ".class")) {
            return in == null ? null : DeclaredMembers.of(in.readAllBytes());
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }
}
