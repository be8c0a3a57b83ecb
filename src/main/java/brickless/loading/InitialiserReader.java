package brickless.loading;

import brickless.kernel.hooks.JdkCalls;
import brickless.loading.ClassSummary.Initialisation;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import org.objectweb.asm.Handle;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/**
 * Finds out whether a static initialiser could block or start something: whether it, or a method or lambda of its own
 * class that it leads to, uses other program classes, threads, monitors or redirected calls.
 *
 * <p>Only into an enum's own methods it looks, because every enum calls some; other classes that do are taken to block.
 */
final class InitialiserReader {
    static final String INITIALISER = "<clinit>()V";

    private static final String THREAD = "java/lang/Thread";
    private static final String LAMBDA_PREFIX = "lambda$";

    private final String self;
    private final Predicate<String> isProgram;
    private final Map<String, Uses> methods = new HashMap<>();
    private boolean isEnum;

    /**
     * Creates a reader for one class.
     *
     * @param isProgram whether a class, by internal name, is rewritten
     */
    InitialiserReader(String self, Predicate<String> isProgram) {
        this.self = self;
        this.isProgram = isProgram;
    }

    void ofEnum(boolean value) {
        isEnum = value;
    }

    /** What reads a method's code; null if it does not matter. */
    MethodVisitor method(int access, String signature) {
        if (!isEnum && !signature.equals(INITIALISER) && !signature.startsWith(LAMBDA_PREFIX)) {
            return null;
        }
        Uses uses = new Uses((access & Opcodes.ACC_SYNCHRONIZED) != 0);
        methods.put(signature, uses);
        return uses;
    }

    /** After all methods: what the initialiser does. */
    Initialisation initialisation() {
        Deque<String> open = new ArrayDeque<>(Set.of(INITIALISER));
        Set<String> seen = new HashSet<>();
        while (!open.isEmpty()) {
            String signature = open.pop();
            Uses uses = methods.get(signature);
            if (uses != null && seen.add(signature)) {
                if (uses.mayBlock) {
                    return Initialisation.MAY_BLOCK;
                }
                open.addAll(uses.ownMethods);
            }
        }
        return Initialisation.HARMLESS;
    }

    /** What one method does by itself, and which methods of its class it calls. */
    private final class Uses extends MethodVisitor {
        private final Set<String> ownMethods = new HashSet<>();
        private boolean mayBlock;

        Uses(boolean isSynchronized) {
            super(Opcodes.ASM9);
            mayBlock = isSynchronized;
        }

        private void uses(String owner) {
            mayBlock |= THREAD.equals(owner) || isProgram.test(owner);
        }

        private void calls(String owner, String signature, boolean lambda) {
            if (owner.equals(self) && (isEnum || lambda)) {
                ownMethods.add(signature);
            } else {
                uses(owner);
            }
        }

        @Override
        public void visitTypeInsn(int opcode, String type) {
            if (opcode == Opcodes.NEW && !(isEnum && type.equals(self))) {
                uses(type);
            }
        }

        @Override
        public void visitFieldInsn(int opcode, String owner, String name, String descriptor) {
            if (!owner.equals(self) && (opcode == Opcodes.GETSTATIC || opcode == Opcodes.PUTSTATIC)) {
                uses(owner);
            }
        }

        @Override
        public void visitMethodInsn(int opcode, String owner, String name, String descriptor,
                boolean ownerIsInterface) {
            mayBlock |= !JdkCalls.withSignature(name, descriptor).isEmpty();
            calls(owner, name + descriptor, false);
        }

        /** What a lambda does counts as done: it may be called before the initialiser ends. */
        @Override
        public void visitInvokeDynamicInsn(String name, String descriptor, Handle bootstrap, Object... arguments) {
            for (Object argument : arguments) {
                if (argument instanceof Handle) {
                    Handle target = (Handle) argument;
                    calls(target.getOwner(), target.getName() + target.getDesc(),
                            target.getName().startsWith(LAMBDA_PREFIX));
                }
            }
        }

        @Override
        public void visitInsn(int opcode) {
            mayBlock |= opcode == Opcodes.MONITORENTER;
        }
    }
}
