package brickless.loading;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.FrameNode;
import org.objectweb.asm.tree.InsnList;
import org.objectweb.asm.tree.InsnNode;
import org.objectweb.asm.tree.IntInsnNode;
import org.objectweb.asm.tree.LabelNode;
import org.objectweb.asm.tree.LdcInsnNode;
import org.objectweb.asm.tree.LineNumberNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;

/** Small pieces of bytecode that several passes insert. */
final class Code {
    static final String OBJECT = "java/lang/Object";
    static final String THROWABLE = "java/lang/Throwable";
    static final String HOOKS = "brickless/kernel/hooks/Hooks";
    static final String MONITORS = "brickless/kernel/hooks/MonitorHooks";

    private static final int FIRST_WITH_CLASS_CONSTANTS = Opcodes.V1_5;
    private static final int FIRST_WITH_FRAMES = Opcodes.V1_6;
    private static final int MAJOR_VERSION_MASK = 0xFFFF;

    private Code() {}

    /** A call of a static method. */
    static MethodInsnNode call(String owner, String name, String descriptor) {
        return new MethodInsnNode(Opcodes.INVOKESTATIC, owner, name, descriptor, false);
    }

    /** Pushes a class in code of {@code type}; class files before version 49 have no class constants. */
    static InsnList classConstant(ClassNode type, String pushed) {
        InsnList code = new InsnList();
        if ((type.version & MAJOR_VERSION_MASK) >= FIRST_WITH_CLASS_CONSTANTS) {
            code.add(new LdcInsnNode(Type.getObjectType(pushed)));
        } else {
            code.add(new LdcInsnNode(pushed.replace('/', '.')));
            code.add(call("java/lang/Class", "forName", "(Ljava/lang/String;)Ljava/lang/Class;"));
        }
        return code;
    }

    /** Whether the class file has stack map frames. */
    static boolean hasFrames(ClassNode type) {
        return (type.version & MAJOR_VERSION_MASK) >= FIRST_WITH_FRAMES;
    }

    /** Pushes a small constant. */
    static AbstractInsnNode push(int value) {
        if (value >= -1 && value <= 5) {
            return new InsnNode(Opcodes.ICONST_0 + value);
        }
        return new IntInsnNode(Opcodes.BIPUSH, value);
    }

    /** Whether the instruction leaves the method normally. */
    static boolean isReturn(AbstractInsnNode instruction) {
        return instruction.getOpcode() >= Opcodes.IRETURN && instruction.getOpcode() <= Opcodes.RETURN;
    }

    /**
     * Inserts code before a method's first instruction, on the method's first line, so that stack traces from there
     * have a line.
     */
    static void insertAtStart(MethodNode method, InsnList code) {
        for (AbstractInsnNode node : method.instructions) {
            if (node instanceof LineNumberNode) {
                LabelNode label = new LabelNode();
                code.insert(new LineNumberNode(((LineNumberNode) node).line, label));
                code.insert(label);
                break;
            }
        }
        method.instructions.insert(code);
    }

    /**
     * The last node that belongs to the start of a handler: insertions go after it. A label that follows may be one
     * that frames refer to for a NEW instruction, so nothing may come between it and that instruction.
     */
    static AbstractInsnNode startOf(LabelNode handler) {
        AbstractInsnNode start = handler;
        for (AbstractInsnNode node = handler; node != null && node.getOpcode() < 0; node = node.getNext()) {
            boolean before = node instanceof FrameNode || node instanceof LineNumberNode && start.getNext() == node;
            start = before ? node : start;
        }
        return start;
    }
}
