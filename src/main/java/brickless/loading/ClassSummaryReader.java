package brickless.loading;

import brickless.loading.ClassSummary.Initialisation;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.FieldVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/** Reads a {@link ClassSummary} from a class file. */
final class ClassSummaryReader extends ClassVisitor {
    private final String self;
    private final JdkReplacements replacements;
    private final InitialiserReader initialiser;
    private final Set<String> methods = new HashSet<>();
    private final Set<String> staticFields = new HashSet<>();
    private final Set<String> computedFields = new HashSet<>();
    private String superName;
    private List<String> interfaces = List.of();
    private boolean isInterface;
    private boolean hasDefaultMethods;

    private ClassSummaryReader(String self, JdkReplacements replacements, Predicate<String> isProgram) {
        super(Opcodes.ASM9);
        this.self = self;
        this.replacements = replacements;
        this.initialiser = new InitialiserReader(self,
                name -> isProgram.test(JdkReplacements.isReplacement(self) ? name : replacements.map(name)));
    }

    /**
     * Reads a summary.
     *
     * @param isProgram whether a class, by internal name, is rewritten
     */
    static ClassSummary read(ClassFile file, String name, JdkReplacements replacements, Predicate<String> isProgram) {
        ClassSummaryReader reader = new ClassSummaryReader(name, replacements, isProgram);
        try {
            ClassFiles.reader(file, name).accept(reader, ClassReader.SKIP_DEBUG | ClassReader.SKIP_FRAMES);
        } catch (IllegalArgumentException | IndexOutOfBoundsException damaged) {
            throw ClassFiles.damaged(file, name, damaged);
        }
        return reader.summary();
    }

    private ClassSummary summary() {
        Initialisation initialisation = methods.contains(InitialiserReader.INITIALISER)
                ? initialiser.initialisation() : Initialisation.NONE;
        return new ClassSummary(superName, interfaces, isInterface, hasDefaultMethods, Set.copyOf(methods),
                Set.copyOf(staticFields), Set.copyOf(computedFields), initialisation);
    }

    @Override
    public void visit(int version, int access, String name, String signature, String superclass, String[] parents) {
        isInterface = (access & Opcodes.ACC_INTERFACE) != 0;
        superName = superclass == null || JdkReplacements.isReplacement(name) ? superclass
                : replacements.map(superclass);
        interfaces = parents == null ? List.of() : List.of(parents);
        initialiser.ofEnum("java/lang/Enum".equals(superclass));
    }

    @Override
    public FieldVisitor visitField(int access, String name, String descriptor, String signature, Object value) {
        if ((access & Opcodes.ACC_STATIC) != 0) {
            staticFields.add(name);
            if (value == null) {
                computedFields.add(name);
            }
        }
        return null;
    }

    @Override
    public MethodVisitor visitMethod(int access, String name, String descriptor, String signature,
            String[] exceptions) {
        methods.add(name + descriptor);
        hasDefaultMethods |= isInterface && (access & (Opcodes.ACC_STATIC | Opcodes.ACC_ABSTRACT)) == 0;
        return initialiser.method(access, name + descriptor);
    }
}
