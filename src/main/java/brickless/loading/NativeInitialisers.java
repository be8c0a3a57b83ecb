package brickless.loading;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.FrameNode;
import org.objectweb.asm.tree.InsnList;
import org.objectweb.asm.tree.InsnNode;
import org.objectweb.asm.tree.LabelNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.TryCatchBlockNode;

/**
 * Static initialisers that stay the JVM's, because they only compute: the thread keeps the processor until they end. If
 * it lost it in between, whoever needs the class next would wait for it on the host, for ever.
 */
final class NativeInitialisers implements MethodPass {
    private static final String NOTHING = "()V";

    private final ClassCatalog catalog;

    NativeInitialisers(ClassCatalog catalog) {
        this.catalog = catalog;
    }

    @Override
    public void rewrite(ClassNode type, MethodNode method) {
        if (!method.name.equals("<clinit>") || catalog.isGuarded(type.name) || !mayEnterTheKernel(method)) {
            return;
        }
        LabelNode start = new LabelNode();
        LabelNode handler = new LabelNode();
        InsnList code = method.instructions;
        for (AbstractInsnNode node : code.toArray()) {
            if (Code.isReturn(node)) {
                code.insertBefore(node, Code.call(Code.HOOKS, "initialiserEnds", NOTHING));
            }
        }
        InsnList begin = new InsnList();
        begin.add(Code.call(Code.HOOKS, "initialiserBegins", NOTHING));
        begin.add(start);
        Code.insertAtStart(method, begin);
        code.add(handler);
        if (Code.hasFrames(type)) {
            code.add(new FrameNode(Opcodes.F_NEW, 0, new Object[0], 1, new Object[] {Code.THROWABLE}));
        }
        code.add(Code.call(Code.HOOKS, "initialiserEnds", NOTHING));
        code.add(new InsnNode(Opcodes.ATHROW));
        method.tryCatchBlocks.add(new TryCatchBlockNode(start, handler, handler, null));
    }

    private static boolean mayEnterTheKernel(MethodNode method) {
        for (AbstractInsnNode node : method.instructions) {
            if (node instanceof MethodInsnNode && ((MethodInsnNode) node).owner.equals(Code.HOOKS)) {
                return true;
            }
        }
        return false;
    }
}
