package brickless.loading;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.Label;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/** Class files from before Java 6: no frames, no class constants, subroutines for finally. */
class OldClassFilesTest {
    private static final int PUBLIC_STATIC = Opcodes.ACC_PUBLIC | Opcodes.ACC_STATIC;

    private final RecordingMachine machine = new RecordingMachine();

    @ParameterizedTest
    @ValueSource(ints = {Opcodes.V1_1, Opcodes.V1_4, Opcodes.V1_5})
    void staticSynchronizedMethodsLockTheirClass(int version, @TempDir Path folder) throws Exception {
        Class<?> old = load(folder, version);
        assertThat(old.getMethod("locked").invoke(null)).isEqualTo(3);
        assertThat(machine.calls).containsExactly("monitorEnter Class", "monitorExit Class");
    }

    @ParameterizedTest
    @ValueSource(ints = {Opcodes.V1_1, Opcodes.V1_4, Opcodes.V1_5})
    void subroutinesStillWork(int version, @TempDir Path folder) throws Exception {
        Class<?> old = load(folder, version);
        assertThat(old.getMethod("viaSubroutine", int.class).invoke(null, 5)).isEqualTo(16);
    }

    @ParameterizedTest
    @ValueSource(ints = {Opcodes.V1_1, Opcodes.V1_4, Opcodes.V1_5})
    void staticInitialisersRunOnFibres(int version, @TempDir Path folder) throws Exception {
        Class<?> old = load(folder, version);
        old.getMethod("$init").invoke(null);
        assertThat(machine.calls).contains("sleep 7000000");
    }

    private Class<?> load(Path folder, int version) throws IOException, ClassNotFoundException {
        Files.write(folder.resolve("Old.class"), old(version));
        try (RobotClassLoader loader = RobotClassLoader.ofPaths(List.of(folder))) {
            loader.bind(machine.machine());
            return Class.forName("Old", true, loader);
        }
    }

    private static byte[] old(int version) {
        ClassWriter writer = new ClassWriter(ClassWriter.COMPUTE_MAXS);
        writer.visit(version, Opcodes.ACC_PUBLIC | Opcodes.ACC_SUPER, "Old", null, "java/lang/Object", null);
        MethodVisitor locked = writer.visitMethod(PUBLIC_STATIC | Opcodes.ACC_SYNCHRONIZED, "locked", "()I", null,
                null);
        locked.visitCode();
        locked.visitInsn(Opcodes.ICONST_3);
        locked.visitInsn(Opcodes.IRETURN);
        end(locked);
        MethodVisitor initialiser = writer.visitMethod(Opcodes.ACC_STATIC, "<clinit>", "()V", null, null);
        initialiser.visitCode();
        initialiser.visitLdcInsn(7L);
        initialiser.visitMethodInsn(Opcodes.INVOKESTATIC, "java/lang/Thread", "sleep", "(J)V", false);
        initialiser.visitInsn(Opcodes.RETURN);
        end(initialiser);
        viaSubroutine(writer.visitMethod(PUBLIC_STATIC, "viaSubroutine", "(I)I", null, null));
        writer.visitEnd();
        return writer.toByteArray();
    }

    /**
     * {@code x = argument; do { x = x * 2 + 3 in a subroutine } while (x < 0); String.valueOf(x); return x + 3}, with a
     * handler around.
     */
    private static void viaSubroutine(MethodVisitor method) {
        Label start = new Label();
        Label handler = new Label();
        Label subroutine = new Label();
        method.visitCode();
        method.visitTryCatchBlock(start, handler, handler, null);
        method.visitLabel(start);
        method.visitJumpInsn(Opcodes.JSR, subroutine);
        method.visitVarInsn(Opcodes.ILOAD, 0);
        method.visitJumpInsn(Opcodes.IFLT, start);
        method.visitVarInsn(Opcodes.ILOAD, 0);
        method.visitMethodInsn(Opcodes.INVOKESTATIC, "java/lang/String", "valueOf", "(I)Ljava/lang/String;", false);
        method.visitInsn(Opcodes.POP);
        method.visitVarInsn(Opcodes.ILOAD, 0);
        method.visitInsn(Opcodes.ICONST_3);
        method.visitInsn(Opcodes.IADD);
        method.visitInsn(Opcodes.IRETURN);
        method.visitLabel(handler);
        method.visitInsn(Opcodes.ATHROW);
        method.visitLabel(subroutine);
        method.visitVarInsn(Opcodes.ASTORE, 1);
        method.visitVarInsn(Opcodes.ILOAD, 0);
        method.visitInsn(Opcodes.ICONST_2);
        method.visitInsn(Opcodes.IMUL);
        method.visitInsn(Opcodes.ICONST_3);
        method.visitInsn(Opcodes.IADD);
        method.visitVarInsn(Opcodes.ISTORE, 0);
        method.visitVarInsn(Opcodes.RET, 1);
        end(method);
    }

    private static void end(MethodVisitor method) {
        method.visitMaxs(0, 0);
        method.visitEnd();
    }
}
