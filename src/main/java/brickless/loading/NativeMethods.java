package brickless.loading;

import java.util.ArrayList;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.InsnList;
import org.objectweb.asm.tree.InsnNode;
import org.objectweb.asm.tree.LdcInsnNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.TypeInsnNode;

/**
 * Native methods cannot run on a virtual brick: they load, and throw an UnsatisfiedLinkError that says so when called.
 */
final class NativeMethods {
    private static final String ERROR = "java/lang/UnsatisfiedLinkError";

    private NativeMethods() {}

    static void replace(ClassNode type, String origin) {
        for (MethodNode method : type.methods) {
            if ((method.access & Opcodes.ACC_NATIVE) != 0) {
                method.access &= ~Opcodes.ACC_NATIVE;
                method.tryCatchBlocks = new ArrayList<>();
                method.instructions = thrower(type.name.replace('/', '.') + "." + method.name + " (" + origin
                        + "): native methods cannot run on a virtual brick");
            }
        }
    }

    private static InsnList thrower(String message) {
        InsnList code = new InsnList();
        code.add(new TypeInsnNode(Opcodes.NEW, ERROR));
        code.add(new InsnNode(Opcodes.DUP));
        code.add(new LdcInsnNode(message));
        code.add(new MethodInsnNode(Opcodes.INVOKESPECIAL, ERROR, "<init>", "(Ljava/lang/String;)V", false));
        code.add(new InsnNode(Opcodes.ATHROW));
        return code;
    }
}
