package brickless.loading;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.MethodNode;

/** {@code synchronized} blocks: monitorenter and monitorexit become calls of the robot's virtual monitors. */
final class MonitorCalls implements MethodPass {
    private static final String LOCK_ONLY = "(Ljava/lang/Object;)V";

    @Override
    public void rewrite(ClassNode type, MethodNode method) {
        for (AbstractInsnNode node : method.instructions.toArray()) {
            if (node.getOpcode() == Opcodes.MONITORENTER) {
                method.instructions.set(node, Code.call(Code.MONITORS, "enter", LOCK_ONLY));
            } else if (node.getOpcode() == Opcodes.MONITOREXIT) {
                method.instructions.set(node, Code.call(Code.MONITORS, "exit", LOCK_ONLY));
            }
        }
    }
}
