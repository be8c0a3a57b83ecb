package brickless.loading;

import brickless.kernel.hooks.ClassInitialization;
import java.util.HashSet;
import java.util.Set;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.FieldInsnNode;
import org.objectweb.asm.tree.InsnList;
import org.objectweb.asm.tree.InsnNode;
import org.objectweb.asm.tree.LabelNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.TryCatchBlockNode;
import org.objectweb.asm.tree.VarInsnNode;

/**
 * Call depth: methods that call others count themselves in and out, so that endless recursion ends in a
 * StackOverflowError at the same depth on every host. A local variable keeps the method's depth for returns and
 * handlers.
 */
final class CallDepth implements MethodPass {
    private final ClassCatalog catalog;

    CallDepth(ClassCatalog catalog) {
        this.catalog = catalog;
    }

    @Override
    public void rewrite(ClassNode type, MethodNode method) {
        if (!callsOthers(method) || method.name.startsWith(MethodReferenceBridges.UNCOUNTED)) {
            return;
        }
        int depth = ExtraLocal.add(method, Opcodes.INTEGER);
        Set<LabelNode> handlers = new HashSet<>();
        for (TryCatchBlockNode block : method.tryCatchBlocks) {
            handlers.add(block.handler);
        }
        for (AbstractInsnNode node : method.instructions.toArray()) {
            if (Code.isReturn(node)) {
                method.instructions.insertBefore(node, leave(depth));
            } else if (node instanceof LabelNode && handlers.contains(node)) {
                method.instructions.insert(Code.startOf((LabelNode) node), restore(depth));
            }
        }
        InsnList enter = new InsnList();
        enter.add(Code.call(Code.HOOKS, "enter", "()I"));
        enter.add(new VarInsnNode(Opcodes.ISTORE, depth));
        Code.insertAtStart(method, enter);
    }

    private boolean callsOthers(MethodNode method) {
        for (AbstractInsnNode node : method.instructions) {
            if (node.getOpcode() == Opcodes.INVOKEDYNAMIC || node instanceof MethodInsnNode
                    && !isHarmless((MethodInsnNode) node)) {
                return true;
            }
        }
        return false;
    }

    private boolean isHarmless(MethodInsnNode call) {
        boolean triggers = call.name.equals(ClassInitialization.TRIGGER);
        return call.owner.equals(Code.HOOKS) || call.owner.equals(Code.OBJECT) && "<init>".equals(call.name)
                || triggers && !catalog.mayBlock(InterfaceStatics.interfaceOf(call.owner));
    }

    private static InsnList leave(int depth) {
        InsnList code = new InsnList();
        code.add(new VarInsnNode(Opcodes.ILOAD, depth));
        code.add(new InsnNode(Opcodes.ICONST_M1));
        code.add(new InsnNode(Opcodes.IADD));
        code.add(new FieldInsnNode(Opcodes.PUTSTATIC, Code.HOOKS, "depth", "I"));
        return code;
    }

    private static InsnList restore(int depth) {
        InsnList code = new InsnList();
        code.add(new VarInsnNode(Opcodes.ILOAD, depth));
        code.add(new FieldInsnNode(Opcodes.PUTSTATIC, Code.HOOKS, "depth", "I"));
        return code;
    }
}
