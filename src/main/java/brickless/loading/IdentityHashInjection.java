package brickless.loading;

import java.util.ArrayList;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.FieldInsnNode;
import org.objectweb.asm.tree.FieldNode;
import org.objectweb.asm.tree.InsnNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.VarInsnNode;

/**
 * Classes that would have the host's identity hash get a sequential one: a field drawn at first use, and a hashCode
 * unless they have their own. Done once per family, in the class whose superclass is the JDK's.
 */
final class IdentityHashInjection implements ClassPass {
    private static final String INTERFACE = "brickless/kernel/hooks/IdentityHashed";
    private static final String HASHES = "brickless/kernel/hooks/IdentityHashes";
    private static final String FIELD = "$identityHash";
    private static final String METHOD = "bricklessIdentityHash";
    private static final String RETURNS_INT = "()I";

    @Override
    public void rewrite(ClassNode type) {
        boolean isClass = (type.access & (Opcodes.ACC_INTERFACE | Opcodes.ACC_MODULE)) == 0;
        if (!isClass || type.superName == null || !JdkTypes.hasIdentityHash(type.superName)) {
            return;
        }
        type.interfaces = new ArrayList<>(type.interfaces);
        type.interfaces.add(INTERFACE);
        type.fields.add(new FieldNode(Opcodes.ACC_PRIVATE | Opcodes.ACC_TRANSIENT | Opcodes.ACC_SYNTHETIC, FIELD, "I",
                null, null));
        type.methods.add(identityHash(type));
        if (type.methods.stream().noneMatch(method -> "hashCode".equals(method.name)
                && RETURNS_INT.equals(method.desc))) {
            type.methods.add(hashCode(type));
        }
    }

    /** {@code return this.hash = IdentityHashes.orNext(this.hash)}. */
    private static MethodNode identityHash(ClassNode type) {
        MethodNode method = new MethodNode(Opcodes.ACC_PUBLIC | Opcodes.ACC_SYNTHETIC, METHOD, RETURNS_INT, null, null);
        method.instructions.add(new VarInsnNode(Opcodes.ALOAD, 0));
        method.instructions.add(new InsnNode(Opcodes.DUP));
        method.instructions.add(new FieldInsnNode(Opcodes.GETFIELD, type.name, FIELD, "I"));
        method.instructions.add(Code.call(HASHES, "orNext", "(I)I"));
        method.instructions.add(new InsnNode(Opcodes.DUP_X1));
        method.instructions.add(new FieldInsnNode(Opcodes.PUTFIELD, type.name, FIELD, "I"));
        method.instructions.add(new InsnNode(Opcodes.IRETURN));
        return method;
    }

    private static MethodNode hashCode(ClassNode type) {
        MethodNode method = new MethodNode(Opcodes.ACC_PUBLIC | Opcodes.ACC_SYNTHETIC, "hashCode", RETURNS_INT, null,
                null);
        method.instructions.add(new VarInsnNode(Opcodes.ALOAD, 0));
        method.instructions.add(new MethodInsnNode(Opcodes.INVOKEVIRTUAL, type.name, METHOD, RETURNS_INT, false));
        method.instructions.add(new InsnNode(Opcodes.IRETURN));
        return method;
    }
}
