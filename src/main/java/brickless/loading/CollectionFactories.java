package brickless.loading;

import java.util.Map;
import org.objectweb.asm.Handle;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.InvokeDynamicInsnNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;

/**
 * {@code Set.of(…)} and {@code Map.of(…)} keep the order given. They have a dozen signatures each, so the calls
 * become invokedynamic ones whose arguments are collected; the class file is of Java 9 or later, or it could not
 * call them.
 */
final class CollectionFactories implements MethodPass {
    private static final String HOOKS = "brickless/kernel/hooks/CollectionHooks";
    private static final String BOOTSTRAP = "(Ljava/lang/invoke/MethodHandles$Lookup;Ljava/lang/String;"
            + "Ljava/lang/invoke/MethodType;)Ljava/lang/invoke/CallSite;";
    private static final Map<String, String> COLLECTORS = Map.of("java/util/Set", "setOf", "java/util/Map", "mapOf");

    @Override
    public void rewrite(ClassNode type, MethodNode method) {
        for (AbstractInsnNode node : method.instructions.toArray()) {
            if (node.getOpcode() == Opcodes.INVOKESTATIC) {
                MethodInsnNode call = (MethodInsnNode) node;
                if ("of".equals(call.name) && COLLECTORS.containsKey(call.owner)) {
                    Handle bootstrap = new Handle(Opcodes.H_INVOKESTATIC, HOOKS, "collecting", BOOTSTRAP, false);
                    method.instructions.set(call, new InvokeDynamicInsnNode(COLLECTORS.get(call.owner), call.desc,
                            bootstrap));
                }
            }
        }
    }
}
