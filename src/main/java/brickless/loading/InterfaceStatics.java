package brickless.loading;

import brickless.kernel.hooks.ClassInitialization;
import java.util.HashSet;
import java.util.Set;
import org.objectweb.asm.Handle;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.FieldNode;
import org.objectweb.asm.tree.InvokeDynamicInsnNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;

/**
 * The class beside an interface that holds its computed constants and their initialiser: fields of an interface are
 * final, so only the JVM could set them there, and only once.
 */
final class InterfaceStatics {
    private InterfaceStatics() {}

    /** The name of the class for an interface. */
    static String nameFor(String interfaceName) {
        return interfaceName + ClassInitialization.STATICS_SUFFIX;
    }

    /** Whether it is the name of such a class. */
    static boolean isName(String name) {
        return name.endsWith(ClassInitialization.STATICS_SUFFIX);
    }

    /** The interface that a class of that name is for; the name itself if it is none. */
    static String interfaceOf(String name) {
        return isName(name) ? name.substring(0, name.length() - ClassInitialization.STATICS_SUFFIX.length()) : name;
    }

    /** Takes the initialiser out of an interface that has been rewritten; null if it has none. */
    static ClassNode takeOutOf(ClassNode type) {
        MethodNode initialiser = type.methods.stream()
                .filter(method -> ClassInitialization.INITIALISER.equals(method.name)).findFirst().orElse(null);
        if (initialiser == null || (type.access & Opcodes.ACC_INTERFACE) == 0) {
            return null;
        }
        ClassNode statics = new ClassNode();
        statics.version = type.version;
        statics.access = Opcodes.ACC_PUBLIC | Opcodes.ACC_FINAL | Opcodes.ACC_SYNTHETIC | Opcodes.ACC_SUPER;
        statics.name = nameFor(type.name);
        statics.superName = Code.OBJECT;
        statics.sourceFile = type.sourceFile;
        statics.nestHostClass = type.nestHostClass;
        for (FieldNode field : type.fields) {
            if (field.value == null) {
                FieldNode moved = new FieldNode(Opcodes.ACC_PUBLIC | Opcodes.ACC_STATIC, field.name,
                        field.desc, null, null);
                moved.visitAttribute(new OnceFinal());
                statics.fields.add(moved);
            }
        }
        type.methods.remove(initialiser);
        statics.methods.add(initialiser);
        openTo(initialiser, type);
        return statics;
    }

    /** The classes beside nested interfaces reach private members of the classes around them. */
    static void addToNest(ClassNode host, ClassCatalog catalog) {
        if (host.nestMembers != null) {
            host.nestMembers.addAll(host.nestMembers.stream()
                    .filter(member -> catalog.isInterface(member) && catalog.initialises(member))
                    .map(InterfaceStatics::nameFor).toList());
        }
    }

    /** Private static methods, lambda bodies among them, that the initialiser uses become public. */
    private static void openTo(MethodNode initialiser, ClassNode type) {
        Set<String> used = new HashSet<>();
        for (AbstractInsnNode node : initialiser.instructions) {
            if (node instanceof MethodInsnNode call) {
                used.add(call.name + call.desc);
            } else if (node instanceof InvokeDynamicInsnNode dynamic) {
                for (Object argument : dynamic.bsmArgs) {
                    if (argument instanceof Handle target) {
                        used.add(target.getName() + target.getDesc());
                    }
                }
            }
        }
        for (MethodNode method : type.methods) {
            if ((method.access & Opcodes.ACC_STATIC) != 0 && used.contains(method.name + method.desc)) {
                method.access = method.access & ~Opcodes.ACC_PRIVATE | Opcodes.ACC_PUBLIC;
            }
        }
    }
}
