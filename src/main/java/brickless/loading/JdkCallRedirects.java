package brickless.loading;

import brickless.kernel.hooks.JdkCall;
import brickless.kernel.hooks.JdkCall.Kind;
import brickless.kernel.hooks.JdkCalls;
import java.util.Set;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;

/**
 * Calls listed in {@link JdkCalls} go to hooks. What counts is where the lookup of the method ends, so
 * {@code MyThread.sleep(5)} is found.
 */
final class JdkCallRedirects implements MethodPass {
    /** Final classes whose toString and hashCode are specified: asking a hook would only cost time. */
    private static final Set<String> DETERMINISTIC = Set.of(
            "java/lang/String", "java/lang/StringBuilder", "java/lang/StringBuffer",
            "java/lang/Integer", "java/lang/Long", "java/lang/Short", "java/lang/Byte",
            "java/lang/Character", "java/lang/Boolean", "java/math/BigDecimal", "java/math/BigInteger");

    private final ClassCatalog catalog;

    JdkCallRedirects(ClassCatalog catalog) {
        this.catalog = catalog;
    }

    @Override
    public void rewrite(ClassNode type, MethodNode method) {
        for (AbstractInsnNode node : method.instructions.toArray()) {
            if (node instanceof MethodInsnNode) {
                MethodInsnNode call = (MethodInsnNode) node;
                JdkCall redirect = find(call.getOpcode(), call.owner, call.name, call.desc);
                if (redirect != null) {
                    redirect(method, call, redirect);
                }
            }
        }
    }

    /** The table's line for a call, or null. */
    JdkCall find(int opcode, String owner, String name, String descriptor) {
        for (JdkCall redirect : JdkCalls.withSignature(name, descriptor)) {
            if (fits(redirect.kind(), opcode) && isOwner(redirect, owner)) {
                return redirect;
            }
        }
        return null;
    }

    private static boolean fits(Kind kind, int opcode) {
        switch (kind) {
            case STATIC:
                return opcode == Opcodes.INVOKESTATIC;
            case NEW:
                return opcode == Opcodes.INVOKESPECIAL;
            case VIRTUAL:
                return opcode == Opcodes.INVOKEVIRTUAL || opcode == Opcodes.INVOKEINTERFACE;
            case FINAL:
                return opcode != Opcodes.INVOKESTATIC;
            case ARGUMENT:
                return true;
            default:
                return false;
        }
    }

    private boolean isOwner(JdkCall redirect, String owner) {
        if (redirect.name().equals("<init>")) {
            return owner.equals(redirect.owner());
        }
        String jdkOwner = catalog.jdkOwner(owner, redirect.signature());
        return jdkOwner != null && !(redirect.owner().equals(Code.OBJECT) && DETERMINISTIC.contains(jdkOwner))
                && JdkTypes.isSubtype(jdkOwner, redirect.owner());
    }

    private static void redirect(MethodNode method, MethodInsnNode call, JdkCall redirect) {
        switch (redirect.kind()) {
            case NEW:
                StringBuilder arguments = new StringBuilder(call.desc.substring(0, call.desc.length() - 2));
                for (String[] supplier : redirect.suppliers()) {
                    method.instructions.insertBefore(call, Code.call(supplier[0], supplier[1], supplier[2]));
                    arguments.append(supplier[2].substring(2));
                }
                call.desc = arguments + ")V";
                break;
            case ARGUMENT:
                method.instructions.insertBefore(call,
                        Code.call(redirect.hookOwner(), redirect.hookName(), redirect.hookDescriptor()));
                call.desc = redirect.convertedDescriptor();
                break;
            default:
                method.instructions.set(call, Code.call(redirect.hookOwner(), redirect.hookName(),
                        redirect.hookDescriptor()));
        }
    }
}
