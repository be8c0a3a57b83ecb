package brickless.loading;

import java.util.ArrayList;
import java.util.List;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.FrameNode;
import org.objectweb.asm.tree.MethodNode;

/** A local variable that a pass adds to a method: it is set before the first instruction, so every frame knows it. */
final class ExtraLocal {
    private ExtraLocal() {}

    /**
     * Adds a variable behind the present ones.
     *
     * @param verificationType its type as frames name it, such as {@link Opcodes#INTEGER}
     * @return its index
     */
    static int add(MethodNode method, Object verificationType) {
        int index = method.maxLocals++;
        for (AbstractInsnNode node : method.instructions) {
            if (node instanceof FrameNode) {
                FrameNode frame = (FrameNode) node;
                List<Object> locals = new ArrayList<>(frame.local == null ? List.of() : frame.local);
                padTo(locals, index);
                locals.add(verificationType);
                frame.local = locals;
            }
        }
        return index;
    }

    /** Frame locals that know nothing but one variable. */
    static Object[] only(int index, Object verificationType) {
        List<Object> locals = new ArrayList<>();
        padTo(locals, index);
        locals.add(verificationType);
        return locals.toArray();
    }

    private static void padTo(List<Object> locals, int index) {
        int slots = 0;
        for (Object type : locals) {
            slots += type == Opcodes.LONG || type == Opcodes.DOUBLE ? 2 : 1;
        }
        for (; slots < index; slots++) {
            locals.add(Opcodes.TOP);
        }
    }
}
