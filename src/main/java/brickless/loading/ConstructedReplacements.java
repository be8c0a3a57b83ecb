package brickless.loading;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.TypeInsnNode;

/**
 * JDK classes that are replaced by a subclass of ours: {@code new Thread()} and {@code extends Thread} use the
 * subclass, and static methods that the replacement declares too are called there. Types stay the JDK's.
 */
final class ConstructedReplacements implements ClassPass, MethodPass {
    private final JdkReplacements replacements;

    ConstructedReplacements(JdkReplacements replacements) {
        this.replacements = replacements;
    }

    @Override
    public void rewrite(ClassNode type) {
        if (type.superName != null) {
            type.superName = constructed(type, type.superName);
        }
    }

    @Override
    public void rewrite(ClassNode type, MethodNode method) {
        for (AbstractInsnNode node : method.instructions.toArray()) {
            if (node.getOpcode() == Opcodes.NEW) {
                TypeInsnNode creation = (TypeInsnNode) node;
                creation.desc = constructed(type, creation.desc);
            } else if (node.getOpcode() == Opcodes.INVOKESPECIAL) {
                MethodInsnNode call = (MethodInsnNode) node;
                call.owner = constructed(type, call.owner);
            } else if (node.getOpcode() == Opcodes.INVOKESTATIC) {
                MethodInsnNode call = (MethodInsnNode) node;
                call.owner = staticOwner(type, call.owner, call.name + call.desc);
            }
        }
    }

    /** What {@code new} and {@code extends} mean in a class: only the replacement itself means the JDK's. */
    String constructed(ClassNode type, String name) {
        String replacement = replacements.constructed(name);
        return replacement == null || replacement.equals(type.name) ? name : replacement;
    }

    /** Where a static call in a class goes: only replacements mean the JDK's. */
    String staticOwner(ClassNode type, String owner, String signature) {
        String replacement = JdkReplacements.isReplacement(type.name) ? null
                : replacements.staticOwner(owner, signature);
        return replacement == null ? owner : replacement;
    }

    /** Whether creating, or calling a static method of, a JDK class means another one. */
    boolean concerns(String owner, String signature) {
        return replacements.constructed(owner) != null || replacements.staticOwner(owner, signature) != null;
    }
}
