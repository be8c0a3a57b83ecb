package brickless.loading;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;

/**
 * Finalizers are renamed, so that the host's garbage collector never runs program code; calls by the program itself
 * still find them.
 */
final class Finalizers implements ClassPass {
    private static final String NAME = "finalize";
    private static final String RENAMED = "$finalize";
    private static final String DESCRIPTOR = "()V";

    private final ClassCatalog catalog;

    Finalizers(ClassCatalog catalog) {
        this.catalog = catalog;
    }

    @Override
    public void rewrite(ClassNode type) {
        for (MethodNode method : type.methods) {
            boolean isStatic = (method.access & Opcodes.ACC_STATIC) != 0;
            if (NAME.equals(method.name) && DESCRIPTOR.equals(method.desc) && !isStatic) {
                method.name = RENAMED;
            }
            for (AbstractInsnNode node : method.instructions) {
                if (node instanceof MethodInsnNode && node.getOpcode() != Opcodes.INVOKESTATIC) {
                    renameCall((MethodInsnNode) node);
                }
            }
        }
    }

    private void renameCall(MethodInsnNode call) {
        boolean finalizer = NAME.equals(call.name) && DESCRIPTOR.equals(call.desc);
        if (finalizer && catalog.jdkOwner(call.owner, NAME + DESCRIPTOR) == null) {
            call.name = RENAMED;
        }
    }
}
