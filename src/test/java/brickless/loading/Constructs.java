package brickless.loading;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.Handle;
import org.objectweb.asm.Label;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/**
 * What a compiled program uses, in words: {@code call java/lang/Thread.sleep}, {@code reference java/lang/Thread.sleep}
 * (a method reference), {@code new java/util/Random}, {@code extends java/lang/Thread}, {@code monitor}, {@code loop} …
 */
final class Constructs extends ClassVisitor {
    private final Set<String> found = new TreeSet<>();

    private Constructs() {
        super(Opcodes.ASM9);
    }

    /** Of a class of the test class path and everything nested in it. */
    static Set<String> of(String mainClass) {
        Constructs constructs = new Constructs();
        try {
            Path file = Path.of(Constructs.class.getResource("/" + mainClass.replace('.', '/') + ".class").toURI());
            String name = file.getFileName().toString().replace(".class", "");
            try (Stream<Path> siblings = Files.list(file.getParent())) {
                for (Path each : siblings.filter(path -> path.getFileName().toString()
                        .matches(name + "(\\$.*)?\\.class")).toList()) {
                    new ClassReader(Files.readAllBytes(each)).accept(constructs, ClassReader.SKIP_DEBUG);
                }
            }
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        } catch (java.net.URISyntaxException impossible) {
            throw new IllegalStateException(impossible);
        }
        return constructs.found;
    }

    @Override
    public void visit(int version, int access, String name, String signature, String parent, String[] interfaces) {
        found.add("extends " + parent);
    }

    @Override
    public MethodVisitor visitMethod(int access, String name, String descriptor, String signature,
            String[] exceptions) {
        if ((access & Opcodes.ACC_SYNCHRONIZED) != 0) {
            found.add((access & Opcodes.ACC_STATIC) != 0 ? "static synchronized" : "synchronized");
        }
        if (name.startsWith("lambda$") || name.equals("<clinit>") || name.equals("finalize")) {
            found.add(name.startsWith("lambda$") ? "lambda" : name);
        }
        return new Code();
    }

    private final class Code extends MethodVisitor {
        private final Set<Label> passed = new HashSet<>();

        Code() {
            super(Opcodes.ASM9);
        }

        @Override
        public void visitLabel(Label label) {
            passed.add(label);
        }

        @Override
        public void visitJumpInsn(int opcode, Label target) {
            found.add(passed.contains(target) ? "loop" : "jump");
        }

        @Override
        public void visitTableSwitchInsn(int first, int last, Label otherwise, Label... targets) {
            found.add("switch");
        }

        @Override
        public void visitLookupSwitchInsn(Label otherwise, int[] keys, Label[] targets) {
            found.add("switch");
        }

        @Override
        public void visitTypeInsn(int opcode, String type) {
            found.add((opcode == Opcodes.NEW ? "new " : opcode == Opcodes.ANEWARRAY ? "array " : "type ") + type);
        }

        @Override
        public void visitIntInsn(int opcode, int operand) {
            if (opcode == Opcodes.NEWARRAY) {
                found.add("array");
            }
        }

        @Override
        public void visitMultiANewArrayInsn(String descriptor, int dimensions) {
            found.add("array of arrays");
        }

        @Override
        public void visitInsn(int opcode) {
            if (opcode == Opcodes.MONITORENTER) {
                found.add("monitor");
            }
        }

        @Override
        public void visitFieldInsn(int opcode, String owner, String name, String descriptor) {
            found.add("field " + owner + "." + name);
        }

        @Override
        public void visitMethodInsn(int opcode, String owner, String name, String descriptor,
                boolean ownerIsInterface) {
            found.add("call " + owner + "." + name);
            found.add("call " + name);
        }

        @Override
        public void visitInvokeDynamicInsn(String name, String descriptor, Handle bootstrap, Object... arguments) {
            for (Object argument : arguments) {
                if (argument instanceof Handle) {
                    Handle target = (Handle) argument;
                    found.add("reference " + target.getOwner() + "." + target.getName());
                }
            }
        }
    }
}
