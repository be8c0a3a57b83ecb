package brickless.loading;

import brickless.kernel.hooks.JdkCalls;
import brickless.loading.ClassSummary.Initialisation;
import java.util.HashSet;
import java.util.Set;
import java.util.function.Predicate;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.FieldVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/** Reads a {@link ClassSummary} from a class file. */
final class ClassSummaryReader extends ClassVisitor {
    private static final String THREAD = "java/lang/Thread";

    private final String self;
    private final JdkReplacements replacements;
    private final Predicate<String> isProgram;
    private final Set<String> methods = new HashSet<>();
    private final Set<String> staticFields = new HashSet<>();
    private String superName;
    private boolean isInterface;
    private Initialisation initialisation = Initialisation.NONE;

    private ClassSummaryReader(String self, JdkReplacements replacements, Predicate<String> isProgram) {
        super(Opcodes.ASM9);
        this.self = self;
        this.replacements = replacements;
        this.isProgram = isProgram;
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
        return new ClassSummary(reader.superName, reader.isInterface, Set.copyOf(reader.methods),
                Set.copyOf(reader.staticFields),
                reader.initialisation);
    }

    @Override
    public void visit(int version, int access, String name, String signature, String superclass, String[] interfaces) {
        isInterface = (access & Opcodes.ACC_INTERFACE) != 0;
        superName = superclass == null || JdkReplacements.isReplacement(name) ? superclass
                : replacements.map(superclass);
    }

    @Override
    public FieldVisitor visitField(int access, String name, String descriptor, String signature, Object value) {
        if ((access & Opcodes.ACC_STATIC) != 0) {
            staticFields.add(name);
        }
        return null;
    }

    @Override
    public MethodVisitor visitMethod(int access, String name, String descriptor, String signature,
            String[] exceptions) {
        methods.add(name + descriptor);
        if (!"<clinit>".equals(name)) {
            return null;
        }
        initialisation = Initialisation.HARMLESS;
        return new InitialiserReader();
    }

    /**
     * Looks for anything that could block or start something: other program classes, threads, monitors, redirected
     * calls.
     */
    private final class InitialiserReader extends MethodVisitor {
        InitialiserReader() {
            super(Opcodes.ASM9);
        }

        private void uses(String owner) {
            if (THREAD.equals(owner) || isProgram.test(JdkReplacements.isReplacement(self) ? owner
                    : replacements.map(owner))) {
                initialisation = Initialisation.MAY_BLOCK;
            }
        }

        @Override
        public void visitTypeInsn(int opcode, String type) {
            if (opcode == Opcodes.NEW) {
                uses(type);
            }
        }

        @Override
        public void visitFieldInsn(int opcode, String owner, String name, String descriptor) {
            if (!owner.equals(self) && (opcode == Opcodes.GETSTATIC || opcode == Opcodes.PUTSTATIC)) {
                uses(owner);
            }
        }

        @Override
        public void visitMethodInsn(int opcode, String owner, String name, String descriptor,
                boolean ownerIsInterface) {
            if (!JdkCalls.withSignature(name, descriptor).isEmpty()) {
                initialisation = Initialisation.MAY_BLOCK;
            }
            uses(owner);
        }

        @Override
        public void visitInsn(int opcode) {
            if (opcode == Opcodes.MONITORENTER) {
                initialisation = Initialisation.MAY_BLOCK;
            }
        }
    }
}
