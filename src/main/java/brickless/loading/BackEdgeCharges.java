package brickless.loading;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.InsnList;
import org.objectweb.asm.tree.JumpInsnNode;
import org.objectweb.asm.tree.LabelNode;
import org.objectweb.asm.tree.LookupSwitchInsnNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.TableSwitchInsnNode;

/**
 * Loops are charged at every jump back, and lambda bodies at their entry: an empty callback that a JDK method calls in
 * a loop must reach the budget check too.
 */
final class BackEdgeCharges implements MethodPass {
    private static final String LAMBDA_PREFIX = "lambda$";

    @Override
    public void rewrite(ClassNode type, MethodNode method) {
        if (DrawingLoops.contain(type.name)) {
            return;
        }
        Map<AbstractInsnNode, Integer> positions = positions(method);
        for (AbstractInsnNode node : method.instructions.toArray()) {
            for (LabelNode target : targets(node)) {
                if (positions.get(target) <= positions.get(node)) {
                    String hook = node instanceof JumpInsnNode && PureSpin.isPure(target, node) ? "spin" : "tick";
                    method.instructions.insertBefore(node, Code.call(Code.HOOKS, hook, "()V"));
                    break;
                }
            }
        }
        if (method.name.startsWith(LAMBDA_PREFIX)) {
            InsnList entry = new InsnList();
            entry.add(Code.call(Code.HOOKS, "tick", "()V"));
            Code.insertAtStart(method, entry);
        }
    }

    private static Map<AbstractInsnNode, Integer> positions(MethodNode method) {
        Map<AbstractInsnNode, Integer> positions = new IdentityHashMap<>();
        for (AbstractInsnNode node : method.instructions) {
            positions.put(node, positions.size());
        }
        return positions;
    }

    private static List<LabelNode> targets(AbstractInsnNode node) {
        List<LabelNode> targets = new ArrayList<>();
        if (node instanceof JumpInsnNode && node.getOpcode() != Opcodes.JSR) {
            targets.add(((JumpInsnNode) node).label);
        } else if (node instanceof TableSwitchInsnNode) {
            targets.addAll(((TableSwitchInsnNode) node).labels);
            targets.add(((TableSwitchInsnNode) node).dflt);
        } else if (node instanceof LookupSwitchInsnNode) {
            targets.addAll(((LookupSwitchInsnNode) node).labels);
            targets.add(((LookupSwitchInsnNode) node).dflt);
        }
        return targets;
    }
}
