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
        if (type.superName != null && !JdkReplacements.isReplacement(type.name)) {
            type.superName = orSame(type.superName);
        }
    }

    @Override
    public void rewrite(ClassNode type, MethodNode method) {
        String ownParent = JdkReplacements.isReplacement(type.name) ? type.superName : null;
        for (AbstractInsnNode node : method.instructions.toArray()) {
            if (node.getOpcode() == Opcodes.NEW) {
                TypeInsnNode creation = (TypeInsnNode) node;
                creation.desc = creation.desc.equals(ownParent) ? ownParent : orSame(creation.desc);
            } else if (node.getOpcode() == Opcodes.INVOKESPECIAL) {
                MethodInsnNode call = (MethodInsnNode) node;
                call.owner = call.owner.equals(ownParent) ? ownParent : orSame(call.owner);
            } else if (node.getOpcode() == Opcodes.INVOKESTATIC && ownParent == null) {
                MethodInsnNode call = (MethodInsnNode) node;
                String owner = replacements.staticOwner(call.owner, call.name + call.desc);
                call.owner = owner == null ? call.owner : owner;
            }
        }
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
