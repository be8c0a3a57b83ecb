package brickless.loading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.jar.JarFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/** The JDK's verifier accepts rewritten classes of ordinary libraries, compiled by many compilers for many versions. */
class VerificationTest {
    /** Every n-th class, to keep the test short; -Dbrickless.verify.every=1 takes all (about 15,000). */
    private static final int EVERY = Integer.getInteger("brickless.verify.every", 4);

    @Test
    void libraryClassesPassTheVerifierAfterRewriting() throws IOException {
        List<Path> jars = new ArrayList<>();
        for (String entry : System.getProperty("java.class.path").split(File.pathSeparator)) {
            if (entry.endsWith(".jar")) {
                jars.add(Path.of(entry));
            }
        }
        int linked = 0;
        List<String> refused = new ArrayList<>();
        LoadingRules rules = LoadingRules.standard().rewriting("org.").rewriting("junit.");
        try (RobotClassLoader loader = RobotClassLoader.ofPaths(jars, rules)) {
            List<String> names = classNames(jars);
            for (int i = 0; i < names.size(); i += EVERY) {
                String outcome = link(loader, names.get(i));
                if (outcome == null) {
                    linked++;
                } else if (!outcome.startsWith("missing")) {
                    refused.add(outcome);
                }
            }
        }
        assertThat(refused).isEmpty();
        assertThat(linked).isGreaterThan(12_000 / EVERY);
    }

    private static List<String> classNames(List<Path> jars) throws IOException {
        List<String> names = new ArrayList<>();
        for (Path path : jars) {
            try (JarFile jar = new JarFile(path.toFile())) {
                jar.stream().map(entry -> entry.getName())
                        .filter(name -> name.endsWith(".class") && !name.startsWith("META-INF/")
                        && !name.endsWith("module-info.class"))
                        .map(name -> name.substring(0, name.length() - ".class".length()).replace('/', '.'))
                        .forEach(names::add);
            }
        }
        return names;
    }

    /** Null if the class could be linked; asking for its methods makes the JVM link, and so verify, it. */
    private static String link(ClassLoader loader, String name) {
        try {
            Class.forName(name, false, loader).getDeclaredMethods();
            return null;
        } catch (ClassNotFoundException | NoClassDefFoundError missing) {
            boolean ours = missing.getMessage().contains("brickless");
            return (ours ? "not found by " : "missing for ") + name + ": " + missing;
        } catch (LinkageError refused) {
            return name + ": " + refused;
        }
    }

    @Test
    void theVerifierReallyRuns(@TempDir Path folder) throws IOException {
        ClassWriter writer = new ClassWriter(0);
        writer.visit(Opcodes.V1_8, Opcodes.ACC_PUBLIC, "Broken", null, "java/lang/Object", null);
        MethodVisitor method = writer.visitMethod(Opcodes.ACC_PUBLIC | Opcodes.ACC_STATIC, "broken", "()I", null, null);
        method.visitCode();
        method.visitInsn(Opcodes.ACONST_NULL);
        method.visitInsn(Opcodes.IRETURN);
        method.visitMaxs(1, 0);
        method.visitEnd();
        writer.visitEnd();
        Files.write(folder.resolve("Broken.class"), writer.toByteArray());
        try (RobotClassLoader loader = RobotClassLoader.ofPaths(List.of(folder))) {
            assertThatThrownBy(() -> Class.forName("Broken", false, loader).getDeclaredMethods())
                    .isInstanceOf(VerifyError.class);
        }
    }
}
