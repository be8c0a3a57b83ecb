package brickless.loading;

import brickless.kernel.hooks.ClassInitialization;
import java.util.ArrayList;
import java.util.List;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.FieldInsnNode;
import org.objectweb.asm.tree.FieldNode;
import org.objectweb.asm.tree.FrameNode;
import org.objectweb.asm.tree.InsnList;
import org.objectweb.asm.tree.InsnNode;
import org.objectweb.asm.tree.JumpInsnNode;
import org.objectweb.asm.tree.LabelNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.TryCatchBlockNode;

/**
 * The methods that initialise a class:
 * <pre>
 * public static void $init() {                // small, so that the JVM inlines it
 *     if (!$initialized) {
 *         $initialize();
 *     }
 * }
 *
 * private static void $initialize() {
 *     if (ClassInitialization.begin(Me.class, mayBlock)) {
 *         try {
 *             Parent.$init();
 *             $clinit$();
 *         } catch (Throwable failure) {
 *             throw ClassInitialization.failed(failure, Me.class);
 *         }
 *         ClassInitialization.complete(Me.class);
 *         $initialized = true;
 *     }
 * }
 * </pre>
 */
final class InitialisationTrigger {
    private static final String HOOKS = "brickless/kernel/hooks/ClassInitialization";
    /** Set when the class is initialised. */
    static final String DONE = "$initialized";
    private static final String NOTHING = "()V";
    private static final int HIDDEN_STATIC = Opcodes.ACC_PRIVATE | Opcodes.ACC_STATIC | Opcodes.ACC_SYNTHETIC;

    private final ClassNode type;
    private final boolean mayBlock;

    private InitialisationTrigger(ClassNode type, boolean mayBlock) {
        this.type = type;
        this.mayBlock = mayBlock;
    }

    /** Adds the methods to a class, with the calls that initialise it. */
    static void add(ClassNode type, List<MethodInsnNode> steps, boolean mayBlock) {
        InitialisationTrigger trigger = new InitialisationTrigger(type, mayBlock);
        type.fields.add(new FieldNode(HIDDEN_STATIC, DONE, "Z", null, null));
        type.methods.add(trigger.fast());
        type.methods.add(trigger.slow(steps));
    }

    private MethodNode fast() {
        MethodNode method = new MethodNode(Opcodes.ACC_PUBLIC | Opcodes.ACC_STATIC | Opcodes.ACC_SYNTHETIC,
                ClassInitialization.TRIGGER, NOTHING, null, null);
        LabelNode end = new LabelNode();
        InsnList code = method.instructions;
        code.add(new FieldInsnNode(Opcodes.GETSTATIC, type.name, DONE, "Z"));
        code.add(new JumpInsnNode(Opcodes.IFNE, end));
        code.add(Code.call(type.name, ClassInitialization.SLOW_TRIGGER, NOTHING));
        code.add(end);
        frame(code);
        code.add(new InsnNode(Opcodes.RETURN));
        return method;
    }

    private MethodNode slow(List<MethodInsnNode> steps) {
        MethodNode method = new MethodNode(HIDDEN_STATIC, ClassInitialization.SLOW_TRIGGER, NOTHING, null, null);
        LabelNode start = new LabelNode();
        LabelNode stop = new LabelNode();
        LabelNode handler = new LabelNode();
        LabelNode end = new LabelNode();
        InsnList code = method.instructions;
        code.add(Code.classConstant(type, type.name));
        code.add(new InsnNode(mayBlock ? Opcodes.ICONST_1 : Opcodes.ICONST_0));
        code.add(Code.call(HOOKS, "begin", "(Ljava/lang/Class;Z)Z"));
        code.add(new JumpInsnNode(Opcodes.IFEQ, end));
        code.add(start);
        steps.forEach(code::add);
        code.add(stop);
        code.add(Code.classConstant(type, type.name));
        code.add(Code.call(HOOKS, "complete", "(Ljava/lang/Class;)V"));
        code.add(new InsnNode(Opcodes.ICONST_1));
        code.add(new FieldInsnNode(Opcodes.PUTSTATIC, type.name, DONE, "Z"));
        code.add(end);
        frame(code);
        code.add(new InsnNode(Opcodes.RETURN));
        code.add(handler);
        frame(code, Code.THROWABLE);
        code.add(Code.classConstant(type, type.name));
        code.add(Code.call(HOOKS, "failed", "(Ljava/lang/Throwable;Ljava/lang/Class;)Ljava/lang/Error;"));
        code.add(new InsnNode(Opcodes.ATHROW));
        method.tryCatchBlocks = new ArrayList<>(List.of(new TryCatchBlockNode(start, stop, handler, null)));
        return method;
    }

    private void frame(InsnList code, Object... stack) {
        if (Code.hasFrames(type)) {
            code.add(new FrameNode(Opcodes.F_NEW, 0, new Object[0], stack.length, stack));
        }
    }
}
