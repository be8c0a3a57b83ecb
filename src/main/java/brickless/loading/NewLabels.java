package brickless.loading;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.FrameNode;
import org.objectweb.asm.tree.LabelNode;
import org.objectweb.asm.tree.MethodNode;

/**
 * Gives every NEW instruction a label of its own, right before it, and makes the frames refer to that one. Frames name
 * an uninitialised object by the label of its NEW; with a label shared by a handler or jump target, code inserted there
 * would separate the two.
 */
final class NewLabels implements MethodPass {
    @Override
    public void rewrite(ClassNode type, MethodNode method) {
        Map<Object, LabelNode> own = new HashMap<>();
        for (AbstractInsnNode node : method.instructions.toArray()) {
            if (node.getOpcode() == Opcodes.NEW) {
                LabelNode label = new LabelNode();
                for (AbstractInsnNode before = node.getPrevious(); before != null
                        && before.getOpcode() < 0; before = before.getPrevious()) {
                    own.put(before, label);
                }
                method.instructions.insertBefore(node, label);
            }
        }
        if (own.isEmpty()) {
            return;
        }
        for (AbstractInsnNode node : method.instructions) {
            if (node instanceof FrameNode) {
                retarget(((FrameNode) node).local, own);
                retarget(((FrameNode) node).stack, own);
            }
        }
    }

    private static void retarget(List<Object> types, Map<Object, LabelNode> own) {
        if (types != null) {
            types.replaceAll(type -> own.containsKey(type) ? own.get(type) : type);
        }
    }
}
