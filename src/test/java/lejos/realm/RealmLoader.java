package lejos.realm;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.Set;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/** Defines {@code lejos} classes anew and redirects their clocks to {@link RealmClock}. */
final class RealmLoader extends ClassLoader {
    private static final Set<String> SHARED = Set.of("lejos.realm.OnPanel", "lejos.realm.RealmLoader");
    private static final Set<String> CLOCKS =
            Set.of("java/lang/Thread.sleep", "java/lang/System.nanoTime", "java/lang/System.currentTimeMillis");

    RealmLoader(ClassLoader parent) {
        super(parent);
    }

    @Override
    protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
        boolean own = name.startsWith("lejos.") && !SHARED.contains(name)
                || name.equals("brickless.hardware.BrickAccess");
        Class<?> loaded = findLoadedClass(name);
        if (loaded != null || !own) {
            return loaded != null ? loaded : super.loadClass(name, resolve);
        }
        byte[] code = rewritten(name);
        return defineClass(name, code, 0, code.length);
    }

    private byte[] rewritten(String name) throws ClassNotFoundException {
        try (InputStream stream = getParent().getResourceAsStream(name.replace('.', '/') + ".class")) {
            if (stream == null) {
                throw new ClassNotFoundException(name);
            }
            ClassWriter writer = new ClassWriter(0);
            new ClassReader(stream).accept(new Redirection(writer), 0);
            return writer.toByteArray();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static final class Redirection extends ClassVisitor {
        Redirection(ClassVisitor next) {
            super(Opcodes.ASM9, next);
        }

        @Override
        public MethodVisitor visitMethod(int access, String name, String descriptor, String signature,
                String[] exceptions) {
            return new MethodVisitor(Opcodes.ASM9, super.visitMethod(access, name, descriptor, signature, exceptions)) {
                @Override
                public void visitMethodInsn(int opcode, String owner, String called, String type, boolean isInterface) {
                    boolean clock = CLOCKS.contains(owner + "." + called);
                    super.visitMethodInsn(opcode, clock ? "lejos/realm/RealmClock" : owner, called, type, isInterface);
                }
            };
        }
    }
}
