package brickless.loading;

import brickless.kernel.hooks.ClassInitialization;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.MethodInsnNode;

/**
 * Recognises loops that only read and compare, such as {@code while (!done) {}}: they wait for another thread and do
 * nothing else.
 */
final class PureSpin {
    private PureSpin() {}

    /**
     * Whether everything from {@code head} up to {@code jump}, which jumps back to it, only loads, compares or jumps.
     */
    static boolean isPure(AbstractInsnNode head, AbstractInsnNode jump) {
        for (AbstractInsnNode node = head; node != jump; node = node.getNext()) {
            if (node.getOpcode() >= 0 && !isPure(node)) {
                return false;
            }
        }
        return true;
    }

    private static boolean isPure(AbstractInsnNode node) {
        int opcode = node.getOpcode();
        if (opcode == Opcodes.INVOKESTATIC) {
            MethodInsnNode call = (MethodInsnNode) node;
            return call.owner.equals(Code.HOOKS) || call.name.equals(ClassInitialization.TRIGGER);
        }
        return opcode <= Opcodes.SALOAD
                || opcode >= Opcodes.I2L && opcode <= Opcodes.IF_ACMPNE
                || opcode == Opcodes.GOTO || opcode == Opcodes.IFNULL || opcode == Opcodes.IFNONNULL
                || opcode == Opcodes.GETSTATIC || opcode == Opcodes.GETFIELD || opcode == Opcodes.ARRAYLENGTH
                || opcode == Opcodes.IAND || opcode == Opcodes.IOR || opcode == Opcodes.IXOR;
    }
}
