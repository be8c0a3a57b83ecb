package brickless.loading;

import java.util.List;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;
import org.objectweb.asm.tree.FieldNode;

/**
 * Writes the class that keeps the static fields of another one for one robot: a field for each, and methods that copy
 * them there and back. It becomes a nest mate of the other one, so that it reaches private fields.
 */
final class StaticStateWriter {
    private static final String STATE = "brickless/kernel/hooks/StaticState";
    private static final String NOTHING = "()V";

    private final String owner;
    private final String self;
    private final List<FieldNode> fields;
    private final ClassWriter writer = new ClassWriter(ClassWriter.COMPUTE_MAXS);

    private StaticStateWriter(String owner, List<FieldNode> fields) {
        this.owner = owner;
        this.self = owner + "$$State";
        this.fields = fields;
    }

    /** The class file for some static fields of a class. */
    static byte[] classFor(Class<?> type, List<FieldNode> fields) {
        return new StaticStateWriter(Type.getInternalName(type), fields).write();
    }

    private byte[] write() {
        writer.visit(Opcodes.V17, Opcodes.ACC_PUBLIC | Opcodes.ACC_FINAL | Opcodes.ACC_SUPER, self, null, STATE, null);
        for (FieldNode field : fields) {
            writer.visitField(Opcodes.ACC_PRIVATE, field.name, field.desc, null, null);
        }
        constructor();
        copy("save", Opcodes.GETSTATIC, Opcodes.PUTFIELD);
        copy("load", Opcodes.GETFIELD, Opcodes.PUTSTATIC);
        isFinal();
        writer.visitEnd();
        return writer.toByteArray();
    }

    /** Fields begin as the JVM would set them. */
    private void constructor() {
        MethodVisitor code = writer.visitMethod(Opcodes.ACC_PUBLIC, "<init>", NOTHING, null, null);
        code.visitVarInsn(Opcodes.ALOAD, 0);
        code.visitMethodInsn(Opcodes.INVOKESPECIAL, STATE, "<init>", NOTHING, false);
        for (FieldNode field : fields) {
            if (field.value != null) {
                code.visitVarInsn(Opcodes.ALOAD, 0);
                code.visitLdcInsn(field.value);
                code.visitFieldInsn(Opcodes.PUTFIELD, self, field.name, field.desc);
            }
        }
        end(code);
    }

    private void copy(String method, int from, int to) {
        MethodVisitor code = writer.visitMethod(Opcodes.ACC_PUBLIC, method, NOTHING, null, null);
        for (FieldNode field : fields) {
            code.visitVarInsn(Opcodes.ALOAD, 0);
            code.visitFieldInsn(from, from == Opcodes.GETSTATIC ? owner : self, field.name, field.desc);
            code.visitFieldInsn(to, to == Opcodes.PUTSTATIC ? owner : self, field.name, field.desc);
        }
        end(code);
    }

    /** After its initialisation, a class whose fields were all final. */
    private void isFinal() {
        MethodVisitor code = writer.visitMethod(Opcodes.ACC_PUBLIC, "isFinal", "()Z", null, null);
        if (fields.stream().allMatch(StaticStateWriter::isSetOnce)
                && fields.stream().anyMatch(field -> field.name.equals(InitialisationTrigger.DONE))) {
            code.visitVarInsn(Opcodes.ALOAD, 0);
            code.visitFieldInsn(Opcodes.GETFIELD, self, InitialisationTrigger.DONE, "Z");
        } else {
            code.visitInsn(Opcodes.ICONST_0);
        }
        code.visitInsn(Opcodes.IRETURN);
        code.visitMaxs(0, 0);
        code.visitEnd();
    }

    private static boolean isSetOnce(FieldNode field) {
        return field.name.equals(InitialisationTrigger.DONE)
                || field.attrs != null && field.attrs.stream().anyMatch(OnceFinal::is);
    }

    private static void end(MethodVisitor code) {
        code.visitInsn(Opcodes.RETURN);
        code.visitMaxs(0, 0);
        code.visitEnd();
    }
}
