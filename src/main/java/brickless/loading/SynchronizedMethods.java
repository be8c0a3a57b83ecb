package brickless.loading;

import java.util.ArrayList;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.FrameNode;
import org.objectweb.asm.tree.InsnList;
import org.objectweb.asm.tree.InsnNode;
import org.objectweb.asm.tree.LabelNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.TryCatchBlockNode;
import org.objectweb.asm.tree.VarInsnNode;

/** {@code synchronized} methods: the flag goes, the body is wrapped in calls of the robot's virtual monitors. */
final class SynchronizedMethods implements MethodPass {
    private static final String LOCK_ONLY = "(Ljava/lang/Object;)V";

    @Override
    public void rewrite(ClassNode type, MethodNode method) {
        if ((method.access & Opcodes.ACC_SYNCHRONIZED) == 0) {
            return;
        }
        method.access &= ~Opcodes.ACC_SYNCHRONIZED;
        int lock = ExtraLocal.add(method, Code.OBJECT);
        for (AbstractInsnNode node : method.instructions.toArray()) {
            if (Code.isReturn(node)) {
                method.instructions.insertBefore(node, exit(lock));
            }
        }
        LabelNode start = new LabelNode();
        Code.insertAtStart(method, enter(type, method, lock, start));
        addHandler(type, method, lock, start);
    }

    private static InsnList enter(ClassNode type, MethodNode method, int lock, LabelNode start) {
        InsnList code = new InsnList();
        if ((method.access & Opcodes.ACC_STATIC) == 0) {
            code.add(new VarInsnNode(Opcodes.ALOAD, 0));
        } else {
            code.add(Code.classConstant(type, type.name));
        }
        code.add(new InsnNode(Opcodes.DUP));
        code.add(new VarInsnNode(Opcodes.ASTORE, lock));
        code.add(Code.call(Code.MONITORS, "enter", LOCK_ONLY));
        code.add(start);
        return code;
    }

    private static InsnList exit(int lock) {
        InsnList code = new InsnList();
        code.add(new VarInsnNode(Opcodes.ALOAD, lock));
        code.add(Code.call(Code.MONITORS, "exit", LOCK_ONLY));
        return code;
    }

    /** The handler is outermost and does not cover itself; its frame knows the lock only. */
    private static void addHandler(ClassNode type, MethodNode method, int lock, LabelNode start) {
        LabelNode handler = new LabelNode();
        InsnList code = method.instructions;
        code.add(handler);
        if (Code.hasFrames(type)) {
            Object[] locals = ExtraLocal.only(lock, Code.OBJECT);
            code.add(new FrameNode(Opcodes.F_NEW, locals.length, locals, 1, new Object[] {Code.THROWABLE}));
        }
        code.add(exit(lock));
        code.add(new InsnNode(Opcodes.ATHROW));
        if (method.tryCatchBlocks == null) {
            method.tryCatchBlocks = new ArrayList<>();
        }
        method.tryCatchBlocks.add(new TryCatchBlockNode(start, handler, handler, null));
    }
}
