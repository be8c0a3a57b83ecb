package brickless.loading;

import java.util.Set;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.FieldInsnNode;
import org.objectweb.asm.tree.MethodNode;

/** {@code System.out}, {@code err} and {@code in} are the robot's console. */
final class StandardStreams implements MethodPass {
    private static final String HOOKS = "brickless/kernel/hooks/SystemHooks";
    private static final Set<String> STREAMS = Set.of("out", "err", "in");

    @Override
    public void rewrite(ClassNode type, MethodNode method) {
        for (AbstractInsnNode node : method.instructions.toArray()) {
            if (node.getOpcode() == Opcodes.GETSTATIC) {
                FieldInsnNode field = (FieldInsnNode) node;
                if ("java/lang/System".equals(field.owner) && STREAMS.contains(field.name)) {
                    method.instructions.set(field, Code.call(HOOKS, field.name, "()" + field.desc));
                }
            }
        }
    }
}
