package brickless.loading;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.commons.Remapper;

/**
 * Which JDK class is replaced by which of ours: {@code jdk-replacements.txt}, narrowed to replacements that exist.
 * Names are internal. Thread-safe; holds names only.
 */
final class JdkReplacements extends Remapper {
    private static final String TABLE = "jdk-replacements.txt";
    private static final String OUR_REPLACEMENTS = "brickless/concurrent/";
    private static final JdkReplacements STANDARD = new JdkReplacements();

    private final List<String[]> lines = read();
    private final Map<String, Optional<Replacement>> known = new ConcurrentHashMap<>();

    private JdkReplacements() {
        super(Opcodes.ASM9);
    }

    /** The replacements for programs. */
    static JdkReplacements standard() {
        return STANDARD;
    }

    /** Whether a class is one of the replacements: where those name a JDK class they mean it. */
    static boolean isReplacement(String internalName) {
        return internalName.startsWith(OUR_REPLACEMENTS);
    }

    /** The name of the class that stands everywhere for a JDK class; the name itself if none does. */
    @Override
    public String map(String internalName) {
        Replacement replacement = find(internalName);
        boolean everywhere = replacement != null && !replacement.isSubclass && !replacement.staticsOnly;
        return everywhere ? replacement.name : internalName;
    }

    /** The subclass that programs construct and extend instead of a JDK class; null if there is none. */
    String constructed(String jdkName) {
        Replacement replacement = find(jdkName);
        return replacement != null && replacement.isSubclass ? replacement.name : null;
    }

    /** The class whose static method stands for a JDK class's static method; null if there is none. */
    String staticOwner(String jdkName, String signature) {
        Replacement replacement = find(jdkName);
        return replacement != null && replacement.staticMethods.contains(signature) ? replacement.name : null;
    }

    private Replacement find(String jdkName) {
        return jdkName.startsWith("java/") ? known.computeIfAbsent(jdkName, this::lookUp).orElse(null) : null;
    }

    private Optional<Replacement> lookUp(String jdkName) {
        for (String[] line : lines) {
            String rest = jdkName.startsWith(line[1]) ? jdkName.substring(line[1].length()) : null;
            if (rest != null && ("package".equals(line[0]) ? rest.indexOf('/') < 0 : isClassOrNested(rest))) {
                return describe(jdkName, line[2] + rest, "statics".equals(line[0]));
            }
        }
        return Optional.empty();
    }

    private static boolean isClassOrNested(String rest) {
        return rest.isEmpty() || rest.startsWith("$");
    }

    private static Optional<Replacement> describe(String jdkName, String name, boolean staticsOnly) {
        try (InputStream in = JdkReplacements.class.getClassLoader().getResourceAsStream(name + ".class")) {
            if (in == null) {
                return Optional.empty();
            }
            ClassReader reader = new ClassReader(in.readAllBytes());
            if ((reader.getAccess() & Opcodes.ACC_PUBLIC) == 0 && name.indexOf('$') < 0) {
                return Optional.empty();
            }
            return Optional.of(new Replacement(name, reader.getSuperName().equals(jdkName), staticsOnly,
                    publicStatics(reader)));
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    private static Set<String> publicStatics(ClassReader reader) {
        Set<String> statics = new HashSet<>();
        reader.accept(new ClassVisitor(Opcodes.ASM9) {
            @Override
            public MethodVisitor visitMethod(int access, String method, String descriptor, String signature,
                    String[] exceptions) {
                if ((access & Opcodes.ACC_STATIC) != 0 && (access & Opcodes.ACC_PUBLIC) != 0) {
                    statics.add(method + descriptor);
                }
                return null;
            }
        }, ClassReader.SKIP_CODE);
        return statics;
    }

    private static List<String[]> read() {
        List<String[]> lines = new ArrayList<>();
        try (InputStream table = JdkReplacements.class.getResourceAsStream(TABLE);
                BufferedReader reader = new BufferedReader(new InputStreamReader(table, StandardCharsets.UTF_8))) {
            for (String line = reader.readLine(); line != null; line = reader.readLine()) {
                if (!line.isBlank() && !line.startsWith("#")) {
                    lines.add(line.trim().split("\\s+"));
                }
            }
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
        return lines;
    }

    /**
     * One replacement.
     *
     * @param isSubclass whether it extends the class it replaces
     * @param staticMethods names and descriptors of its public static methods
     */
    private record Replacement(String name, boolean isSubclass, boolean staticsOnly, Set<String> staticMethods) {}
}
