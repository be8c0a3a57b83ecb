package brickless.loading;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.TypeInsnNode;

/**
 * JDK classes that are replaced by a subclass of ours: {@code new Thread()} and {@code extends Thread} use the subclass, and static methods
 * that the replacement declares too are called there. Types stay the JDK's.
 */
final class ConstructedReplacements implements ClassPass, MethodPass {
    private static final String OUR_REPLACEMENTS = "brickless/concurrent/";

    private final JdkReplacements replacements;

    ConstructedReplacements(JdkReplacements replacements) {
        this.replacements = replacements;
    }

    @Override
    public void rewrite(ClassNode type) {
        if (type.superName != null && !isReplacement(type)) {
            type.superName = orSame(type.superName);
        }
    }

    @Override
    public void rewrite(ClassNode type, MethodNode method) {
        for (AbstractInsnNode node : method.instructions.toArray()) {
            if (node.getOpcode() == Opcodes.NEW) {
                TypeInsnNode creation = (TypeInsnNode) node;
                creation.desc = isReplacement(type) && creation.desc.equals(type.superName) ? creation.desc : orSame(creation.desc);
            } else if (node.getOpcode() == Opcodes.INVOKESPECIAL && !(isReplacement(type) && ((MethodInsnNode) node).owner.equals(type.superName))) {
                ((MethodInsnNode) node).owner = orSame(((MethodInsnNode) node).owner);
            } else if (node.getOpcode() == Opcodes.INVOKESTATIC && !isReplacement(type)) {
                MethodInsnNode call = (MethodInsnNode) node;
                String owner = replacements.staticOwner(call.owner, call.name + call.desc);
                call.owner = owner == null ? call.owner : owner;
            }
        }
    }

    /** Whether a class is one of the replacements: those may extend and call the JDK's. */
    private static boolean isReplacement(ClassNode type) {
        return type.name.startsWith(OUR_REPLACEMENTS);
    }

    /** Whether creating, or calling a static method of, a JDK class means another one. */
    boolean concerns(String owner, String signature) {
        return replacements.constructed(owner) != null || replacements.staticOwner(owner, signature) != null;
    }

    private String orSame(String jdkName) {
        String constructed = replacements.constructed(jdkName);
        return constructed == null ? jdkName : constructed;
    }
}
