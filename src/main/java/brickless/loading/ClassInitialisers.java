package brickless.loading;

import brickless.kernel.hooks.ClassInitialization;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
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
import org.objectweb.asm.tree.TypeInsnNode;

/**
 * Class initialisation in virtual time: a static initialiser that may block is renamed, and every use of the class in
 * another class calls its trigger first. A native {@code <clinit>} frame could not be switched away.
 */
final class ClassInitialisers implements ClassPass, MethodPass {
    private static final String DONE = "$initialized";
    private static final String HOOKS = "brickless/kernel/hooks/ClassInitialization";

    private final ClassCatalog catalog;

    ClassInitialisers(ClassCatalog catalog) {
        this.catalog = catalog;
    }

    /** Renames the class's own initialiser. */
    @Override
    public void rewrite(ClassNode type) {
        if (!catalog.ownInitialiserOnFibre(type.name)) {
            return;
        }
        for (MethodNode method : type.methods) {
            if ("<clinit>".equals(method.name)) {
                method.name = ClassInitialization.INITIALISER;
                method.access = Opcodes.ACC_PRIVATE | Opcodes.ACC_STATIC | Opcodes.ACC_SYNTHETIC;
            }
        }
        for (FieldNode field : type.fields) {
            if ((field.access & Opcodes.ACC_STATIC) != 0 && field.value == null) {
                field.access &= ~Opcodes.ACC_FINAL;
            }
        }
    }

    /** Calls the triggers of other classes before they are used. */
    @Override
    public void rewrite(ClassNode type, MethodNode method) {
        for (AbstractInsnNode node : method.instructions.toArray()) {
            String used = usedClass(node);
            if (used == null || used.equals(type.name) || !catalog.initialisesOnFibre(used)
                    || catalog.isSuperclass(used, type.name)) {
                continue;
            }
            MethodInsnNode trigger = Code.call(used, ClassInitialization.TRIGGER, "()V");
            if (node.getOpcode() == Opcodes.NEW) {
                method.instructions.insert(node, trigger);
            } else {
                method.instructions.insertBefore(node, trigger);
            }
        }
    }

    private String usedClass(AbstractInsnNode node) {
        switch (node.getOpcode()) {
            case Opcodes.NEW:
                return ((TypeInsnNode) node).desc;
            case Opcodes.INVOKESTATIC:
                MethodInsnNode call = (MethodInsnNode) node;
                return catalog.declaringClass(call.owner, call.name + call.desc, true);
            case Opcodes.GETSTATIC:
            case Opcodes.PUTSTATIC:
                FieldInsnNode field = (FieldInsnNode) node;
                return catalog.declaringClass(field.owner, field.name, false);
            default:
                return null;
        }
    }

    /** The trigger of a class: unless done, {@code done = ClassInitialization.initialize(type, own)}. */
    void addTrigger(ClassNode type) {
        if (!catalog.initialisesOnFibre(type.name)) {
            return;
        }
        type.fields.add(new FieldNode(Opcodes.ACC_PRIVATE | Opcodes.ACC_STATIC | Opcodes.ACC_SYNTHETIC, DONE, "Z",
                null, null));
        MethodNode trigger = new MethodNode(Opcodes.ACC_PUBLIC | Opcodes.ACC_STATIC | Opcodes.ACC_SYNTHETIC,
                ClassInitialization.TRIGGER,
                "()V", null, null);
        LabelNode end = new LabelNode();
        InsnList code = trigger.instructions;
        code.add(new FieldInsnNode(Opcodes.GETSTATIC, type.name, DONE, "Z"));
        code.add(new JumpInsnNode(Opcodes.IFNE, end));
        code.add(Code.classConstant(type));
        code.add(new InsnNode(catalog.ownInitialiserOnFibre(type.name) ? Opcodes.ICONST_1 : Opcodes.ICONST_0));
        code.add(Code.call(HOOKS, "initialize", "(Ljava/lang/Class;Z)Z"));
        code.add(new FieldInsnNode(Opcodes.PUTSTATIC, type.name, DONE, "Z"));
        code.add(end);
        if (Code.hasFrames(type)) {
            code.add(new FrameNode(Opcodes.F_NEW, 0, new Object[0], 0, new Object[0]));
        }
        code.add(new InsnNode(Opcodes.RETURN));
        type.methods.add(trigger);
    }
}
