package brickless.loading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import brickless.kernel.KernelSettings;
import brickless.kernel.hooks.Hooks;
import brickless.kernel.hooks.VirtualMachine;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.lang.ref.WeakReference;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Who is defined where, what a program sees, and what stays behind. */
class RobotClassLoaderTest {
    private static final String PROGRAM = "programs.passing.threads.PingPong";

    @TempDir
    private Path folder;

    /** Copies a program of the test class path into a folder of its own. */
    private Path copyOfProgram() throws IOException {
        String path = PROGRAM.replace('.', '/') + ".class";
        Path target = folder.resolve("classes").resolve(path);
        Files.createDirectories(target.getParent());
        try (InputStream in = RobotClassLoaderTest.class.getClassLoader().getResourceAsStream(path)) {
            Files.write(target, in.readAllBytes());
        }
        return folder.resolve("classes");
    }

    private Path jar(String entry, byte[] content) throws IOException {
        Path jar = folder.resolve("program.jar");
        try (OutputStream out = Files.newOutputStream(jar); ZipOutputStream zip = new ZipOutputStream(out)) {
            zip.putNextEntry(new ZipEntry(entry));
            zip.write(content);
        }
        return jar;
    }

    @Test
    void everyRobotHasItsOwnProgramAndHooksAndSharesTheKernel() throws Exception {
        Path classes = copyOfProgram();
        try (RobotClassLoader one = RobotClassLoader.ofPaths(List.of(classes)); RobotClassLoader two =
                RobotClassLoader.ofPaths(List.of(classes))) {
            assertThat(one.loadClass(PROGRAM)).isNotSameAs(two.loadClass(PROGRAM));
            assertThat(one.loadClass(Hooks.class.getName())).isNotSameAs(Hooks.class)
                    .isNotSameAs(two.loadClass(Hooks.class.getName()));
            assertThat(one.loadClass(VirtualMachine.class.getName())).isSameAs(VirtualMachine.class);
            assertThat(one.loadClass("java.lang.String")).isSameAs(String.class);
        }
    }

    @Test
    void aProgramFromAFolderRuns() throws IOException {
        try (RobotClassLoader loader = RobotClassLoader.ofPaths(List.of(copyOfProgram()))) {
            assertThat(ProgramRun.run(loader, PROGRAM, KernelSettings.defaults(), "").output())
                    .startsWith("ping 0\npong 0\n");
        }
    }

    @Test
    void aProgramDoesNotSeeTheSimulatorsLibraries() throws IOException {
        try (RobotClassLoader loader = RobotClassLoader.ofPaths(List.of(folder))) {
            assertThatThrownBy(() -> loader.loadClass("org.objectweb.asm.ClassReader"))
                    .isInstanceOf(ClassNotFoundException.class);
            assertThat(loader.getResource("org/objectweb/asm/ClassReader.class")).isNull();
        }
    }

    @Test
    void resourcesComeFromTheProgramsFoldersAndJars() throws IOException {
        Files.write(folder.resolve("a.txt"), "in folder".getBytes(StandardCharsets.UTF_8));
        Path jar = jar("sounds/my b.txt", "in jar".getBytes(StandardCharsets.UTF_8));
        try (RobotClassLoader loader = RobotClassLoader.ofPaths(List.of(folder, jar))) {
            assertThat(text(loader, "a.txt")).isEqualTo("in folder");
            assertThat(text(loader, "sounds/my b.txt")).isEqualTo("in jar");
            assertThat(loader.getResourceAsStream("missing.txt")).isNull();
        }
    }

    private static String text(ClassLoader loader, String path) throws IOException {
        try (InputStream in = loader.getResourceAsStream(path)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    @Test
    void missingAndUnreadableClassPathEntriesAreNamed() throws IOException {
        assertThatThrownBy(() -> RobotClassLoader.ofPaths(List.of(folder.resolve("missing.jar"))))
                .isInstanceOf(NoSuchFileException.class).hasMessageContaining("missing.jar");
        Path noJar = Files.write(folder.resolve("text.jar"), "no jar".getBytes(StandardCharsets.UTF_8));
        assertThatThrownBy(() -> RobotClassLoader.ofPaths(List.of(noJar))).isInstanceOf(IOException.class)
                .hasMessageContaining("text.jar");
    }

    @Test
    void aDamagedClassFileIsOneClearError() throws IOException {
        byte[] whole = Files.readAllBytes(copyOfProgram().resolve(PROGRAM.replace('.', '/') + ".class"));
        assertUnloadable("not a class file".getBytes(StandardCharsets.UTF_8), "not a class file");
        assertUnloadable(new byte[0], "not a class file");
        assertUnloadable(Arrays.copyOf(whole, whole.length / 3), "damaged class file");
        byte[] tooNew = whole.clone();
        tooNew[7] = 120;
        assertUnloadable(tooNew, "compiled for Java 76 but this is Java " + Runtime.version().feature());
    }

    private void assertUnloadable(byte[] bytes, String reason) throws IOException {
        Path jar = jar("Damaged.class", bytes);
        try (RobotClassLoader loader = RobotClassLoader.ofPaths(List.of(jar))) {
            assertThatThrownBy(() -> loader.loadClass("Damaged")).isInstanceOf(UnloadableClassError.class)
                    .hasMessageContaining("Damaged").hasMessageContaining("program.jar").hasMessageContaining(reason);
        }
    }

    @Test
    void aMissingMainIsExplained() throws IOException {
        try (RobotClassLoader loader = RobotClassLoader.ofPaths(List.of(copyOfProgram()))) {
            RecordingMachine machine = new RecordingMachine();
            loader.bind(machine.machine());
            Thread main = loader.mainThread("java.lang.String");
            assertThatThrownBy(main::run).isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("java.lang.String has no");
        }
    }

    @Test
    void aSecondRobotUsesTheBytesRewrittenForTheFirst() throws Exception {
        Path classes = copyOfProgram();
        try (RobotClassLoader one = RobotClassLoader.ofPaths(List.of(classes)); RobotClassLoader two =
                RobotClassLoader.ofPaths(List.of(classes))) {
            one.loadClass(PROGRAM);
            long hits = RewrittenClassCache.shared().hits();
            two.loadClass(PROGRAM);
            assertThat(RewrittenClassCache.shared().hits()).isGreaterThan(hits);
        }
    }

    @Test
    void nothingOfARobotStaysBehindAfterItsRun() {
        WeakReference<ClassLoader> loader =
                new WeakReference<>(loaderOfFinishedRun("programs.passing.threads.ThreadLocals"));
        WeakReference<ClassLoader> stopped =
                new WeakReference<>(loaderOfFinishedRun("programs.failing.runaways.SwallowingEverything"));
        for (int i = 0; i < 100 && (loader.get() != null || stopped.get() != null); i++) {
            System.gc();
        }
        assertThat(loader.get()).isNull();
        assertThat(stopped.get()).isNull();
    }

    private static ClassLoader loaderOfFinishedRun(String program) {
        RobotClassLoader loader = RobotClassLoader.ofApplication();
        ProgramRun.run(loader, program, KernelSettings.defaults().withLimitNanos(1_000_000_000L), "");
        return loader;
    }
}
