package brickless.loading;

import java.util.ArrayList;
import java.util.List;
import org.objectweb.asm.Handle;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.InsnNode;
import org.objectweb.asm.tree.InvokeDynamicInsnNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.TypeInsnNode;
import org.objectweb.asm.tree.VarInsnNode;

/**
 * Method references such as {@code Thread::sleep} or {@code lock::notifyAll} whose target other passes would rewrite: a
 * bridge method with the plain call takes the target's place, and the other passes rewrite the bridge like any code.
 */
final class MethodReferenceBridges implements ClassPass {
    private static final String LAMBDA_FACTORY = "java/lang/invoke/LambdaMetafactory";
    private static final String NAME = "brickless$bridge";
    /** Of bridges that only trigger an initialisation which costs nothing itself: calls of theirs are not counted. */
    static final String UNCOUNTED = "brickless$uncounted";
    private static final int IMPLEMENTATION_ARGUMENT = 1;

    private final JdkCallRedirects redirects;
    private final ConstructedReplacements constructed;
    private final ClassCatalog catalog;

    MethodReferenceBridges(JdkCallRedirects redirects, ConstructedReplacements constructed, ClassCatalog catalog) {
        this.redirects = redirects;
        this.constructed = constructed;
        this.catalog = catalog;
    }

    @Override
    public void rewrite(ClassNode type) {
        List<MethodNode> bridges = new ArrayList<>();
        for (MethodNode method : type.methods) {
            for (AbstractInsnNode node : method.instructions) {
                if (node instanceof InvokeDynamicInsnNode
                        && ((InvokeDynamicInsnNode) node).bsm.getOwner().equals(LAMBDA_FACTORY)) {
                    InvokeDynamicInsnNode reference = (InvokeDynamicInsnNode) node;
                    Handle target = (Handle) reference.bsmArgs[IMPLEMENTATION_ARGUMENT];
                    boolean counts = isRedirected(target) || initialises(type, target)
                            && catalog.mayBlock(target.getOwner());
                    if (counts || initialises(type, target)) {
                        MethodNode bridge = bridge(target, reference.desc,
                                (counts ? NAME : UNCOUNTED) + bridges.size());
                        bridges.add(bridge);
                        boolean inInterface = (type.access & Opcodes.ACC_INTERFACE) != 0;
                        reference.bsmArgs[IMPLEMENTATION_ARGUMENT] =
                                new Handle(Opcodes.H_INVOKESTATIC, type.name, bridge.name, bridge.desc, inInterface);
                    }
                }
            }
        }
        type.methods.addAll(bridges);
    }

    private static boolean touchesStatics(Handle target) {
        return target.getTag() == Opcodes.H_INVOKESTATIC || target.getTag() == Opcodes.H_NEWINVOKESPECIAL;
    }

    private boolean initialises(ClassNode type, Handle target) {
        return touchesStatics(target) && !target.getOwner().equals(type.name) && catalog.initialises(target.getOwner());
    }

    private boolean isRedirected(Handle target) {
        String owner = target.getOwner();
        int opcode = opcode(target.getTag());
        return redirects.find(opcode, owner, target.getName(), target.getDesc()) != null
                || touchesStatics(target) && constructed.concerns(owner, target.getName() + target.getDesc());
    }

    private static int opcode(int tag) {
        switch (tag) {
            case Opcodes.H_INVOKESTATIC:
                return Opcodes.INVOKESTATIC;
            case Opcodes.H_INVOKEINTERFACE:
                return Opcodes.INVOKEINTERFACE;
            case Opcodes.H_INVOKEVIRTUAL:
                return Opcodes.INVOKEVIRTUAL;
            default:
                return Opcodes.INVOKESPECIAL;
        }
    }

    /**
     * A static method that does what the handle does. A bound receiver keeps its static type: the lambda factory
     * insists on it.
     */
    private static MethodNode bridge(Handle target, String capture, String name) {
        boolean creates = target.getTag() == Opcodes.H_NEWINVOKESPECIAL;
        List<Type> parameters = new ArrayList<>();
        if (!creates && target.getTag() != Opcodes.H_INVOKESTATIC) {
            Type[] captured = Type.getArgumentTypes(capture);
            parameters.add(captured.length > 0 ? captured[0] : Type.getObjectType(target.getOwner()));
        }
        parameters.addAll(List.of(Type.getArgumentTypes(target.getDesc())));
        Type result = creates ? Type.getObjectType(target.getOwner()) : Type.getReturnType(target.getDesc());
        MethodNode bridge = new MethodNode(Opcodes.ACC_PRIVATE | Opcodes.ACC_STATIC | Opcodes.ACC_SYNTHETIC, name,
                Type.getMethodDescriptor(result, parameters.toArray(new Type[0])), null, null);
        if (creates) {
            bridge.instructions.add(new TypeInsnNode(Opcodes.NEW, target.getOwner()));
            bridge.instructions.add(new InsnNode(Opcodes.DUP));
        }
        for (Type parameter : parameters) {
            bridge.instructions.add(new VarInsnNode(parameter.getOpcode(Opcodes.ILOAD), bridge.maxLocals));
            bridge.maxLocals += parameter.getSize();
        }
        bridge.instructions.add(new MethodInsnNode(opcode(target.getTag()), target.getOwner(), target.getName(),
                target.getDesc(),
                target.isInterface()));
        bridge.instructions.add(new InsnNode(result.getOpcode(Opcodes.IRETURN)));
        return bridge;
    }
}
