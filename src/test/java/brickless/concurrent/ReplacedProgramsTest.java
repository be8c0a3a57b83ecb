package brickless.concurrent;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.lang.reflect.Method;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.commons.ClassRemapper;
import org.objectweb.asm.commons.Remapper;

/**
 * The programs in {@code programs.passing.concurrency} print the same with the JDK's classes and with their
 * replacements, in real time.
 */
@Timeout(30)
class ReplacedProgramsTest {
    private static final Path SOURCES = Path.of("src/test/java/programs/passing/concurrency");
    private static final String PACKAGE = "programs.passing.concurrency.";
    /** What these print depends on exact times. */
    private static final Set<String> VIRTUAL_TIME_ONLY = Set.of("ScheduledRates", "DelayedTasks");

    static Stream<String> programs() throws IOException {
        try (Stream<Path> files = Files.list(SOURCES)) {
            return files.map(file -> file.getFileName().toString().replace(".java", ""))
                    .filter(name -> !VIRTUAL_TIME_ONLY.contains(name))
                    .sorted().collect(Collectors.toList()).stream();
        }
    }

    @ParameterizedTest
    @MethodSource("programs")
    void printWithTheJdkWhatTheyPromise(String program) throws Exception {
        assertThat(run(Class.forName(PACKAGE + program))).isEqualTo(expected(program));
    }

    @ParameterizedTest
    @MethodSource("programs")
    void printWithTheReplacementsWhatTheyPromise(String program) throws Exception {
        assertThat(run(new ReplacingLoader().loadClass(PACKAGE + program))).isEqualTo(expected(program));
    }

    @Test
    void theReplacingLoaderReplaces() throws Exception {
        Class<?> type = new ReplacingLoader().loadClass(PACKAGE + "PingPong");
        assertThat(type.getDeclaredField("LOCK").getType()).isEqualTo(brickless.concurrent.locks.ReentrantLock.class);
    }

    private static List<String> expected(String program) throws IOException {
        String mark = " * @prints ";
        return Files.readAllLines(SOURCES.resolve(program + ".java")).stream().filter(line -> line.startsWith(mark))
                .map(line -> line.substring(mark.length())).collect(Collectors.toList());
    }

    private static List<String> run(Class<?> program) throws Exception {
        PrintStream original = System.out;
        String threadName = Thread.currentThread().getName();
        ByteArrayOutputStream printed = new ByteArrayOutputStream();
        System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
        Thread.currentThread().setName("main");
        try {
            Method main = program.getMethod("main", String[].class);
            main.invoke(null, (Object) new String[0]);
        } finally {
            System.setOut(original);
            Thread.currentThread().setName(threadName);
        }
        return printed.toString(StandardCharsets.UTF_8).lines().collect(Collectors.toList());
    }

    /** Defines the programs anew with the names of JDK classes replaced. */
    private static final class ReplacingLoader extends ClassLoader {
        ReplacingLoader() {
            super(ReplacedProgramsTest.class.getClassLoader());
        }

        @Override
        protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
            if (!name.startsWith(PACKAGE)) {
                return super.loadClass(name, resolve);
            }
            Class<?> loaded = findLoadedClass(name);
            return loaded == null ? define(name) : loaded;
        }

        private Class<?> define(String name) throws ClassNotFoundException {
            try (InputStream in = getResourceAsStream(name.replace('.', '/') + ".class")) {
                ClassWriter writer = new ClassWriter(0);
                new ClassReader(in.readAllBytes()).accept(new ReplacingRemapper(writer), 0);
                byte[] code = writer.toByteArray();
                return defineClass(name, code, 0, code.length);
            } catch (IOException e) {
                throw new ClassNotFoundException(name, e);
            }
        }
    }

    private static final class ReplacingRemapper extends ClassRemapper {
        ReplacingRemapper(ClassWriter writer) {
            super(Opcodes.ASM9, writer, new Remapper(Opcodes.ASM9) {
                @Override
                public String map(String name) {
                    return replacement(name);
                }
            });
        }

        @Override
        protected MethodVisitor createMethodRemapper(MethodVisitor visitor) {
            return new MethodVisitor(Opcodes.ASM9, super.createMethodRemapper(visitor)) {
                @Override
                public void visitTypeInsn(int opcode, String type) {
                    super.visitTypeInsn(opcode, opcode == Opcodes.NEW ? constructed(type) : type);
                }

                @Override
                public void visitMethodInsn(int opcode, String owner, String name, String descriptor,
                        boolean isInterface) {
                    boolean redirected = opcode == Opcodes.INVOKESPECIAL
                            || opcode == Opcodes.INVOKESTATIC && !owner.equals("java/util/Collections")
                            || name.startsWith("synchronized");
                    super.visitMethodInsn(opcode, redirected ? constructed(owner) : owner, name, descriptor,
                            isInterface);
                }
            };
        }

        private static String constructed(String name) {
            switch (name) {
                case "java/util/concurrent/CompletableFuture":
                case "java/util/concurrent/ConcurrentHashMap":
                    return name.replace("java/util/concurrent", "brickless/concurrent");
                case "java/io/PrintStream":
                    return "brickless/concurrent/io/ProgramPrintStream";
                case "java/util/Collections":
                    return "brickless/concurrent/util/SynchronizedCollections";
                default:
                    return name;
            }
        }

        private static String replacement(String name) {
            if (!constructed(name).equals(name)) {
                return name;
            }
            String ours = name.replaceFirst("^java/util/concurrent/", "brickless/concurrent/")
                    .replaceFirst("^java/util/(?=[A-Z])", "brickless/concurrent/util/")
                    .replaceFirst("^java/io/(?=Piped)", "brickless/concurrent/io/");
            boolean exists = ReplacedProgramsTest.class.getClassLoader().getResource(ours + ".class") != null;
            return exists ? ours : name;
        }
    }
}
