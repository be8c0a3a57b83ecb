package brickless.loading;

import org.objectweb.asm.Handle;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.InvokeDynamicInsnNode;
import org.objectweb.asm.tree.MethodNode;

/**
 * {@code "a" + b} compiled for Java 9 or later: numbers are converted as on every JDK. Older class files use
 * StringBuilder.
 */
final class StringConcatenation implements MethodPass {
    private static final String JDK_FACTORY = "java/lang/invoke/StringConcatFactory";
    private static final String OUR_FACTORY = "brickless/kernel/hooks/ConcatHooks";

    @Override
    public void rewrite(ClassNode type, MethodNode method) {
        for (AbstractInsnNode node : method.instructions) {
            if (node instanceof InvokeDynamicInsnNode) {
                InvokeDynamicInsnNode concat = (InvokeDynamicInsnNode) node;
                if (JDK_FACTORY.equals(concat.bsm.getOwner())) {
                    concat.bsm = new Handle(concat.bsm.getTag(), OUR_FACTORY, concat.bsm.getName(),
                            concat.bsm.getDesc(), false);
                }
            }
        }
    }
}
