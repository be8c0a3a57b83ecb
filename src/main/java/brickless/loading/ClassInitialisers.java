package brickless.loading;

import brickless.kernel.hooks.ClassInitialization;
import java.util.ArrayList;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.FieldInsnNode;
import org.objectweb.asm.tree.FieldNode;
import org.objectweb.asm.tree.InsnList;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.TypeInsnNode;

/**
 * Class initialisation by the program's own code: every static initialiser is renamed, and every use of the class in
 * another class calls its trigger first. The JVM would run an initialiser once, but robots that share the class need
 * it once each; and it would make a second thread that comes along wait on the host.
 */
final class ClassInitialisers implements ClassPass, MethodPass {
    private static final int HIDDEN_STATIC = Opcodes.ACC_PRIVATE | Opcodes.ACC_STATIC | Opcodes.ACC_SYNTHETIC;
    private static final String NOTHING = "()V";

    private final ClassCatalog catalog;
    private final ConstructedReplacements replaced;

    ClassInitialisers(ClassCatalog catalog, ConstructedReplacements replaced) {
        this.catalog = catalog;
        this.replaced = replaced;
    }

    /** Renames the class's own initialiser, and lets it set final fields. */
    @Override
    public void rewrite(ClassNode type) {
        for (MethodNode method : type.methods) {
            if ("<clinit>".equals(method.name)) {
                method.name = ClassInitialization.INITIALISER;
                method.access = HIDDEN_STATIC;
            }
        }
        if ((type.access & Opcodes.ACC_INTERFACE) == 0) {
            for (FieldNode field : type.fields) {
                boolean isFinal = (field.access & Opcodes.ACC_FINAL) != 0;
                if (isFinal && (field.access & Opcodes.ACC_STATIC) != 0 && field.value == null) {
                    field.access &= ~Opcodes.ACC_FINAL;
                    field.visitAttribute(new OnceFinal());
                }
            }
        }
    }

    /** Calls the triggers of other classes before they are used. */
    @Override
    public void rewrite(ClassNode type, MethodNode method) {
        for (AbstractInsnNode node : method.instructions.toArray()) {
            String used = usedClass(type, node);
            if (used == null) {
                continue;
            }
            if (node instanceof FieldInsnNode && catalog.isComputedInInterface(used, ((FieldInsnNode) node).name)) {
                ((FieldInsnNode) node).owner = InterfaceStatics.nameFor(used);
            }
            if (!used.equals(type.name) && !catalog.isSuperclass(used, type.name) && catalog.initialises(used)) {
                // Nothing may come between a NEW and its label, which frames refer to.
                AbstractInsnNode place = node.getOpcode() == Opcodes.NEW ? node.getNext() : node;
                method.instructions.insertBefore(place, trigger(used));
            }
        }
        if (method.name.equals("values") && catalog.isEnum(type.name) && catalog.initialises(type.name)) {
            // The JDK calls it by reflection, for EnumSet and the like.
            InsnList code = new InsnList();
            code.add(trigger(type.name));
            Code.insertAtStart(method, code);
        }
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

    private MethodInsnNode trigger(String used) {
        return Code.call(catalog.isInterface(used) ? InterfaceStatics.nameFor(used) : used,
                ClassInitialization.TRIGGER, NOTHING);
    }

    /** Adds the trigger of a class, or of an interface to the class that holds its statics. */
    void addTrigger(String initialised, ClassNode holder) {
        if (catalog.initialises(initialised)) {
            ArrayList<MethodInsnNode> steps = new ArrayList<>();
            for (String parent : catalog.parentsToInitialise(initialised)) {
                steps.add(trigger(parent));
            }
            if (catalog.summary(initialised).initialisation() != ClassSummary.Initialisation.NONE) {
                steps.add(Code.call(holder.name, ClassInitialization.INITIALISER, NOTHING));
            }
            InitialisationTrigger.add(holder, steps, catalog.mayBlock(initialised));
        }
    }
}
