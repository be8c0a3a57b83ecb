package brickless.loading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import brickless.kernel.KernelSettings;
import brickless.kernel.ProgramEnd;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.Opcodes;

/**
 * A program with threads, locks, loops and initialisers runs the same, whatever version its class files have: 48 to 69.
 */
class ClassFileVersionsTest {
    private static final int FIRST = Opcodes.V1_4;
    private static final int LAST = Opcodes.V25;
    private static final int FIRST_WITH_LAMBDAS = Opcodes.V1_8;
    private static final int RELEASE_OF_VERSION = 44;
    /** What a compiler of 2002 could have produced, but for the version. */
    private static final String PLAIN = """
            public class Versions {
                static final Object LOCK = new Object();
                static final int[] TABLE = new int[5];
                static { for (int i = 0; i < TABLE.length; i++) { TABLE[i] = Slow.value() + i; } }
                static class Slow {
                    static int value;
                    static { try { Thread.sleep(20); } catch (InterruptedException e) { value = -1; } }
                    static int value() { return value; }
                }
                static class Adder extends Thread {
                    final int[] sum;
                    Adder(int[] sum) { this.sum = sum; }
                    public void run() {
                        for (int i = 0; i < 100; i++) { synchronized (LOCK) { sum[0] += add(i); } Thread.yield(); }
                    }
                    synchronized int add(int i) {
                        try {
                            switch (i % 3) { case 0: return 1; case 1: return 2; default: return 3; }
                        } finally { i++; }
                    }
                }
                public static void main(String[] args) throws Exception {
                    int[] sum = new int[1];
                    Thread one = new Adder(sum);
                    Thread two = new Adder(sum);
                    one.start();
                    two.start();
                    one.join();
                    two.join();
                    System.out.println(String.valueOf(sum[0]).concat(" ").concat(String.valueOf(TABLE[4])));
                    BODY
                }
            }
            """;
    /** Lambdas, method references, and what string concatenation and nest mates become from Java 9 and 11. */
    private static final String LAMBDAS = """
            Runnable print = () -> System.out.println("lambda " + LOCK.getClass().getSimpleName() + sum[0]);
            Thread thread = new Thread(print);
            thread.start();
            java.util.function.LongConsumer join = millis -> {
                try {
                    thread.join(millis);
                } catch (InterruptedException e) {
                    throw new IllegalStateException(e);
                }
            };
            join.accept(0);
            java.util.List.of(3, 1, 2).stream().sorted().forEach(System.out::println);
            """;
    private static final List<String> OUTPUT = List.of("398 4");
    private static final List<String> OUTPUT_WITH_LAMBDAS = List.of("398 4", "lambda Object398", "1", "2", "3");

    @TempDir
    private Path folder;

    static IntStream versionsOfThisJvm() {
        return IntStream.rangeClosed(FIRST, Math.min(LAST, Runtime.version().feature() + RELEASE_OF_VERSION));
    }

    static IntStream releasesOfTheCompiler() {
        return versionsOfThisJvm().filter(version -> version >= FIRST_WITH_LAMBDAS)
                .map(version -> version - RELEASE_OF_VERSION);
    }

    @ParameterizedTest
    @MethodSource("versionsOfThisJvm")
    void everyVersionRunsTheSame(int version) throws IOException {
        compile(PLAIN.replace("BODY", ""), "8", "-XDstringConcat=inline");
        relabel(version);
        assertThat(output()).isEqualTo(OUTPUT);
    }

    @ParameterizedTest
    @MethodSource("releasesOfTheCompiler")
    void whatEveryReleaseOfTheCompilerMakesRunsTheSame(int release) throws IOException {
        compile(PLAIN.replace("BODY", release >= 9 ? LAMBDAS
                : LAMBDAS.replace("java.util.List.of", "java.util.Arrays.asList")), Integer.toString(release));
        assertThat(output()).isEqualTo(OUTPUT_WITH_LAMBDAS);
    }

    @Test
    void aVersionFromTheFutureIsRefusedWithItsName() throws IOException {
        compile(PLAIN.replace("BODY", ""), "8", "-XDstringConcat=inline");
        Path file = folder.resolve("Versions.class");
        byte[] bytes = Files.readAllBytes(file);
        bytes[7] = 99;
        Files.write(file, bytes);
        try (RobotClassLoader loader = RobotClassLoader.ofPaths(List.of(folder))) {
            assertThatThrownBy(() -> loader.loadClass("Versions")).isInstanceOf(UnloadableClassError.class)
                    .hasMessageContaining("Versions").hasMessageContaining("compiled for Java 55");
        }
    }

    private List<String> output() throws IOException {
        try (RobotClassLoader loader = RobotClassLoader.ofPaths(List.of(folder))) {
            ProgramRun run = ProgramRun.run(loader, "Versions", KernelSettings.defaults()
                    .withLimitNanos(10_000_000_000L), "");
            assertThat(run.end().kind()).as(run.output()).isEqualTo(ProgramEnd.Kind.EXITED);
            return run.output().lines().toList();
        }
    }

    private void compile(String source, String release, String... options) throws IOException {
        Path file = Files.writeString(folder.resolve("Versions.java"), source);
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        List<String> arguments = new ArrayList<>(List.of("-nowarn", "-Xlint:-options", "--release", release, "-d",
                folder.toString()));
        arguments.addAll(List.of(options));
        arguments.add(file.toString());
        ByteArrayOutputStream messages = new ByteArrayOutputStream();
        assertThat(compiler.run(null, messages, messages, arguments.toArray(String[]::new)))
                .as(messages.toString(StandardCharsets.UTF_8)).isZero();
    }

    /** Gives all class files another version; before version 50 there were no frames, before 49 no class constants. */
    private void relabel(int version) throws IOException {
        for (String name : List.of("Versions", "Versions$Slow", "Versions$Adder")) {
            Path file = folder.resolve(name + ".class");
            ClassWriter writer = new ClassWriter(0);
            new ClassReader(Files.readAllBytes(file)).accept(new ClassVisitor(Opcodes.ASM9, writer) {
                @Override
                public void visit(int old, int access, String type, String signature, String parent,
                        String[] interfaces) {
                    super.visit(version, access, type, signature, parent, interfaces);
                }
            }, version < Opcodes.V1_6 ? ClassReader.SKIP_FRAMES : 0);
            Files.write(file, writer.toByteArray());
        }
    }
}
