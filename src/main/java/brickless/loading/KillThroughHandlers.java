package brickless.loading;

import java.util.LinkedHashSet;
import java.util.Set;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.InsnList;
import org.objectweb.asm.tree.InsnNode;
import org.objectweb.asm.tree.LabelNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.TryCatchBlockNode;

/**
 * Handlers that could swallow the error which ends a program (finally, Throwable, Error) let it pass.
 *
 * <p>A handler that covers its own start, as javac's for monitors do, is left alone: throwing there would enter it
 * again for ever. Its body meets the next hook instead.
 */
final class KillThroughHandlers implements MethodPass {
    private static final Set<String> WIDE = Set.of(Code.THROWABLE, "java/lang/Error", "java/lang/ThreadDeath",
            "brickless/kernel/hooks/ProgramKilled");

    @Override
    public void rewrite(ClassNode type, MethodNode method) {
        Set<LabelNode> handlers = new LinkedHashSet<>();
        for (TryCatchBlockNode block : method.tryCatchBlocks) {
            if ((block.type == null || WIDE.contains(block.type)) && !coversItself(method, block.handler)) {
                handlers.add(block.handler);
            }
        }
        for (LabelNode handler : handlers) {
            InsnList code = new InsnList();
            code.add(new InsnNode(Opcodes.DUP));
            code.add(Code.call(Code.HOOKS, "kill", "(Ljava/lang/Throwable;)V"));
            method.instructions.insert(Code.startOf(handler), code);
        }
    }

    private static boolean coversItself(MethodNode method, LabelNode handler) {
        int start = method.instructions.indexOf(handler);
        for (TryCatchBlockNode block : method.tryCatchBlocks) {
            boolean covered = method.instructions.indexOf(block.start) <= start
                    && method.instructions.indexOf(block.end) > start;
            if (block.handler == handler && covered) {
                return true;
            }
        }
        return false;
    }
}
