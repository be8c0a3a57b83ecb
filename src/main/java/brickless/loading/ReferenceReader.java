package brickless.loading;

import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.ConstantDynamic;
import org.objectweb.asm.FieldVisitor;
import org.objectweb.asm.Handle;
import org.objectweb.asm.Label;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

/** Reports every class and member that a class refers to, with the line. Names are internal. */
final class ReferenceReader extends ClassVisitor {
    /** The class that is reported for a constant which a bootstrap method computes. */
    static final String COMPUTED_CONSTANT = "java/lang/constant/DynamicConstantDesc";

    private final Listener listener;
    private String self;
    private int line;

    ReferenceReader(Listener listener) {
        super(Opcodes.ASM9);
        this.listener = listener;
    }

    /** Hears of references. */
    interface Listener {
        void refers(Reference reference, String user, int line);
    }

    /**
     * A class ({@code member} empty), method (name and descriptor) or field (name, colon, descriptor).
     */
    record Reference(String owner, String member) {}

    private void refers(String owner, String member) {
        if (!owner.startsWith("[")) {
            listener.refers(new Reference(owner, member), self, line);
        } else {
            refersTo(Type.getObjectType(owner));
        }
    }

    private void refersTo(Type type) {
        Type element = type.getSort() == Type.ARRAY ? type.getElementType() : type;
        if (element.getSort() == Type.OBJECT) {
            refers(element.getInternalName(), "");
        } else if (element.getSort() == Type.METHOD) {
            refersTo(element.getReturnType());
            for (Type argument : element.getArgumentTypes()) {
                refersTo(argument);
            }
        }
    }

    @Override
    public void visit(int version, int access, String name, String signature, String superName, String[] interfaces) {
        self = name;
        if (superName != null) {
            refers(superName, "");
        }
        for (String parent : interfaces == null ? new String[0] : interfaces) {
            refers(parent, "");
        }
    }

    @Override
    public FieldVisitor visitField(int access, String name, String descriptor, String signature, Object value) {
        line = 0;
        refersTo(Type.getType(descriptor));
        return null;
    }

    @Override
    public MethodVisitor visitMethod(int access, String name, String descriptor, String signature,
            String[] exceptions) {
        line = 0;
        refersTo(Type.getMethodType(descriptor));
        for (String exception : exceptions == null ? new String[0] : exceptions) {
            refers(exception, "");
        }
        return new CodeReader();
    }

    private final class CodeReader extends MethodVisitor {
        CodeReader() {
            super(Opcodes.ASM9);
        }

        @Override
        public void visitLineNumber(int number, Label start) {
            line = number;
        }

        @Override
        public void visitTypeInsn(int opcode, String type) {
            refers(type, "");
        }

        @Override
        public void visitFieldInsn(int opcode, String owner, String name, String descriptor) {
            refers(owner, name + ":" + descriptor);
        }

        @Override
        public void visitMethodInsn(int opcode, String owner, String name, String descriptor, boolean isInterface) {
            refers(owner, owner.startsWith("[") ? "" : name + descriptor);
        }

        @Override
        public void visitInvokeDynamicInsn(String name, String descriptor, Handle bootstrap, Object... arguments) {
            ReferenceReader.this.refersTo(Type.getMethodType(descriptor));
            refersTo(bootstrap);
            for (Object argument : arguments) {
                refersToConstant(argument);
            }
        }

        private void refersTo(Handle handle) {
            boolean field = handle.getTag() <= Opcodes.H_PUTSTATIC;
            refers(handle.getOwner(), handle.getName() + (field ? ":" : "") + handle.getDesc());
        }

        private void refersToConstant(Object constant) {
            if (constant instanceof Handle) {
                refersTo((Handle) constant);
            } else if (constant instanceof Type) {
                ReferenceReader.this.refersTo((Type) constant);
            } else if (constant instanceof ConstantDynamic) {
                refers(COMPUTED_CONSTANT, "");
                refersTo(((ConstantDynamic) constant).getBootstrapMethod());
            }
        }

        @Override
        public void visitLdcInsn(Object value) {
            refersToConstant(value);
        }

        @Override
        public void visitMultiANewArrayInsn(String descriptor, int dimensions) {
            ReferenceReader.this.refersTo(Type.getType(descriptor));
        }

        @Override
        public void visitTryCatchBlock(Label start, Label end, Label handler, String type) {
            if (type != null) {
                refers(type, "");
            }
        }
    }
}
