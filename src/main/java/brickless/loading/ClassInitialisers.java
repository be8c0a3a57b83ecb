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
 * another class calls its trigger first. The JVM's own initialisation would make a second thread that comes along wait
 * on the host.
 *
 * <p>Only an interface's initialiser has to stay: its fields are final. Uses of it, and of classes with which the JVM
 * would initialise it, ask {@link ClassInitialization} first, so that no second thread comes along.
 */
final class ClassInitialisers implements ClassPass, MethodPass {
    private static final String DONE = "$initialized";
    private static final int GUARD_ACCESS =
            Opcodes.ACC_PUBLIC | Opcodes.ACC_STATIC | Opcodes.ACC_FINAL | Opcodes.ACC_SYNTHETIC;
    private static final String HOOKS = "brickless/kernel/hooks/ClassInitialization";

    private final ClassCatalog catalog;
    private final ConstructedReplacements replaced;

    ClassInitialisers(ClassCatalog catalog, ConstructedReplacements replaced) {
        this.catalog = catalog;
        this.replaced = replaced;
    }

    /** Renames the class's own initialiser. */
    @Override
    public void rewrite(ClassNode type) {
        if (catalog.isGuarded(type.name)) {
            type.fields.add(new FieldNode(GUARD_ACCESS, ClassInitialization.GUARDED, "I", null, 1));
        }
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
            String used = usedClass(type, node);
            if (used == null || used.equals(type.name) || catalog.isSuperclass(used, type.name)) {
                continue;
            }
            if (catalog.isGuarded(used)) {
                // Between a NEW and the label before it, which frames refer to, nothing may come.
                method.instructions.insertBefore(node.getOpcode() == Opcodes.NEW ? node.getPrevious() : node,
                        guard(type, used));
            } else if (catalog.initialisesOnFibre(used)) {
                AbstractInsnNode place = node.getOpcode() == Opcodes.NEW ? node.getNext() : node;
                method.instructions.insertBefore(place, Code.call(used, ClassInitialization.TRIGGER, "()V"));
            }
        }
        if (method.name.equals("values") && catalog.isEnum(type.name) && catalog.initialisesOnFibre(type.name)) {
            // The JDK calls it by reflection, for EnumSet and the like.
            InsnList trigger = new InsnList();
            trigger.add(Code.call(type.name, ClassInitialization.TRIGGER, "()V"));
            Code.insertAtStart(method, trigger);
        }
    }

    private static InsnList guard(ClassNode type, String used) {
        InsnList code = Code.classConstant(type, used);
        code.add(Code.call(HOOKS, "initializeGuarded", "(Ljava/lang/Class;)V"));
        return code;
    }

    private String usedClass(ClassNode type, AbstractInsnNode node) {
        switch (node.getOpcode()) {
            case Opcodes.NEW:
                return replaced.constructed(type, ((TypeInsnNode) node).desc);
            case Opcodes.INVOKESTATIC:
                MethodInsnNode call = (MethodInsnNode) node;
                String signature = call.name + call.desc;
                return catalog.declaringClass(replaced.staticOwner(type, call.owner, signature), signature, true);
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
        code.add(Code.classConstant(type, type.name));
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
