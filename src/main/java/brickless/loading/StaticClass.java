package brickless.loading;

import brickless.kernel.hooks.ClassInitialization;
import brickless.kernel.hooks.StaticState;
import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.util.ArrayList;
import java.util.List;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.FieldVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.FieldNode;

/** A class of a robot and its static fields that can change. */
final class StaticClass {
    private final Class<?> type;
    private final List<FieldNode> fields;
    private final boolean hasInitialiser;
    private MethodHandle constructor;

    private StaticClass(Class<?> type, List<FieldNode> fields, boolean hasInitialiser) {
        this.type = type;
        this.fields = fields;
        this.hasInitialiser = hasInitialiser;
    }

    /** Reads the fields from the file that the class was defined from. */
    static StaticClass of(Class<?> type, byte[] classFile) {
        List<FieldNode> fields = new ArrayList<>();
        boolean[] hasInitialiser = new boolean[1];
        new ClassReader(classFile).accept(new ClassVisitor(Opcodes.ASM9) {
            @Override
            public FieldVisitor visitField(int access, String name, String descriptor, String signature, Object value) {
                if ((access & (Opcodes.ACC_STATIC | Opcodes.ACC_FINAL)) != Opcodes.ACC_STATIC) {
                    return null;
                }
                FieldNode field = new FieldNode(access, name, descriptor, null, value);
                fields.add(field);
                return field;
            }

            @Override
            public MethodVisitor visitMethod(int access, String name, String descriptor, String signature,
                    String[] exceptions) {
                hasInitialiser[0] |= name.equals(ClassInitialization.TRIGGER);
                return null;
            }
        }, ClassReader.SKIP_CODE | ClassReader.SKIP_DEBUG);
        return new StaticClass(type, fields, hasInitialiser[0]);
    }

    /** Whether no static field can change. */
    boolean isEmpty() {
        return fields.isEmpty();
    }

    /** Whether nobody touches the fields before the class's initialisation begins. */
    boolean hasInitialiser() {
        return hasInitialiser;
    }

    /** The state of the class for a robot that has not used it. */
    StaticState fresh() {
        try {
            if (constructor == null) {
                MethodHandles.Lookup inside = ProgramEntry.insideOf(type);
                MethodHandles.Lookup state = inside.defineHiddenClass(StaticStateWriter.classFor(type, fields), false,
                        MethodHandles.Lookup.ClassOption.NESTMATE);
                constructor = state.findConstructor(state.lookupClass(), MethodType.methodType(void.class));
            }
            return (StaticState) constructor.invoke();
        } catch (Throwable broken) {
            throw new LinkageError("static fields of " + type.getName(), broken);
        }
    }
}
