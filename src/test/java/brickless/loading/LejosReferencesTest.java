package brickless.loading;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.Label;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/** A program made by hand against a tiny lejos made by hand. */
class LejosReferencesTest {
    private static final String OBJECT = "java/lang/Object";

    private static ClassWriter type(String name, String superName) {
        ClassWriter writer = new ClassWriter(0);
        writer.visit(Opcodes.V1_8, Opcodes.ACC_PUBLIC, name, null, superName, null);
        return writer;
    }

    private static byte[] beeper() {
        ClassWriter writer = type("lejos/Beeper", OBJECT);
        writer.visitMethod(Opcodes.ACC_PUBLIC | Opcodes.ACC_STATIC | Opcodes.ACC_NATIVE, "beep", "()V", null, null)
                .visitEnd();
        writer.visitField(Opcodes.ACC_PUBLIC | Opcodes.ACC_STATIC, "volume", "I", null, null).visitEnd();
        return writer.toByteArray();
    }

    private static byte[] program() {
        ClassWriter writer = type("my/Program", OBJECT);
        MethodVisitor method = writer.visitMethod(Opcodes.ACC_PUBLIC | Opcodes.ACC_STATIC, "main", "()V", null, null);
        method.visitCode();
        call(method, 10, "lejos/Beeper", "beep");
        call(method, 11, "lejos/Beeper", "sing");
        call(method, 12, "lejos/Singer", "sing");
        call(method, 13, "java/lang/System", "gc");
        call(method, 14, "lejos/LoudBeeper", "beep");
        method.visitFieldInsn(Opcodes.GETSTATIC, "lejos/Beeper", "volume", "I");
        method.visitFieldInsn(Opcodes.GETSTATIC, "lejos/Beeper", "volume", "J");
        method.visitInsn(Opcodes.RETURN);
        method.visitMaxs(4, 0);
        method.visitEnd();
        return writer.toByteArray();
    }

    private static void call(MethodVisitor method, int line, String owner, String name) {
        Label label = new Label();
        method.visitLabel(label);
        method.visitLineNumber(line, label);
        method.visitMethodInsn(Opcodes.INVOKESTATIC, owner, name, "()V", false);
    }

    @Test
    void missingClassesAndMembersAreListedWithTheirLines() {
        Map<String, byte[]> lejos = Map.of("lejos/Beeper", beeper(), "lejos/LoudBeeper",
                type("lejos/LoudBeeper", "lejos/Beeper").toByteArray());
        assertThat(LejosReferences.missing(List.of(program()), lejos::get)).extracting(MissingReference::toString)
                .containsExactly(
                "lejos.Beeper.sing()V used by my.Program:11",
                "lejos.Beeper.volume:J used by my.Program:14",
                "lejos.Singer used by my.Program:12");
    }

    @Test
    void classesThatTheProgramBringsAlongAreNotMissing() {
        assertThat(LejosReferences.missing(List.of(program(), beeper()), Map.<String, byte[]>of()::get))
                .extracting(MissingReference::owner).containsOnly("lejos.Beeper", "lejos.LoudBeeper", "lejos.Singer");
    }
}
