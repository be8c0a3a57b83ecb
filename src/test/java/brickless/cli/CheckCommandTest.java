package brickless.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

/** {@code brickless check}: what a program uses and is not here. */
class CheckCommandTest {
    /** What some other leJOS may have had: an absent class, and members that the class here has not. */
    private static final String LAMP = """
            package lejos.hardware;
            public class LaserLamp {
                public LaserLamp(int port) {}
                public void aim(double[] angles, String name) {}
                public static int power;
            }
            """;
    private static final String SOUND = """
            package lejos.hardware;
            public class Sound {
                public static void sing(int[][] notes, Object voice) {}
                public static int volume;
                public static void beep() {}
            }
            """;
    private static final String PROGRAM = """
            import lejos.hardware.LaserLamp;
            import lejos.hardware.Sound;

            public class Show {
                public static void main(String[] args) {
                    Sound.beep();
                    Sound.sing(null, "alto");
                    LaserLamp lamp = new LaserLamp(1);
                    Sound.volume = 3;
                    Sound.sing(null, "bass");
                }
            }
            """;

    @TempDir Path folder;

    @TestFactory
    Stream<DynamicTest> nothingIsMissingForTheExamplePrograms() throws IOException {
        try (Stream<Path> programs = Files.list(CommandLineRun.program(""))) {
            return programs.sorted().toList().stream().map(program ->
                    DynamicTest.dynamicTest(program.getFileName().toString(), () -> assertNothingIsMissing(program)));
        }
    }

    private static void assertNothingIsMissing(Path program) {
        CommandLineRun run = CommandLineRun.of("check", program);
        assertThat(run.out()).endsWith("nothing of leJOS is missing\n");
        assertThat(run.status()).isZero();
    }

    private Path compiled() throws IOException {
        Path stubs = folder.resolve("stubs");
        Path classes = folder.resolve("classes");
        Files.createDirectories(stubs);
        Files.createDirectories(classes);
        Path lamp = Files.writeString(folder.resolve("LaserLamp.java"), LAMP);
        Path sound = Files.writeString(folder.resolve("Sound.java"), SOUND);
        Path show = Files.writeString(folder.resolve("Show.java"), PROGRAM);
        compile(stubs, stubs, lamp, sound);
        compile(classes, stubs, show);
        return classes;
    }

    private static void compile(Path target, Path classPath, Path... sources) {
        List<String> words = Stream.concat(Stream.of("--release", "8", "-Xlint:none", "-nowarn", "-g", "-d",
                target.toString(), "-cp", classPath.toString()), Stream.of(sources).map(Path::toString)).toList();
        assertThat(ToolProvider.getSystemJavaCompiler()
                .run(null, OutputStream.nullOutputStream(), OutputStream.nullOutputStream(),
                words.toArray(String[]::new))).isZero();
    }

    @Test
    void missingClassesAndMembersAreNamedWithTheProgramsLines() throws IOException {
        Path classes = compiled();
        CommandLineRun run = CommandLineRun.of("check", classes);
        assertThat(run.out().lines()).containsExactly(classes + " uses 3 of leJOS missing here:",
                "  class lejos.hardware.LaserLamp  used by Show:8",
                "  lejos.hardware.Sound.sing(int[][], Object)  used by Show:7, Show:10",
                "  lejos.hardware.Sound.volume  used by Show:9");
        assertThat(run.status()).isEqualTo(1);
    }

    @Test
    void aClassThatIsBroughtAlongIsNotMissing() throws IOException {
        Path classes = compiled();
        assertThat(CommandLineRun.of("check", classes, "--classpath", folder.resolve("stubs")).out())
                .contains("Sound.sing").doesNotContain("LaserLamp");
    }

    @Test
    void sourceThatDoesNotCompileForWantOfLejosNamesItToo() throws IOException {
        compiled();
        CommandLineRun run = CommandLineRun.of("check", folder.resolve("Show.java"));
        assertThat(run.status()).isEqualTo(1);
        assertThat(run.out()).contains("does not compile with this leJOS API")
                .contains("Show.java:1: error: cannot find symbol").contains("class LaserLamp");
    }

    @Test
    void whatIsNoProgramIsRefused() throws IOException {
        assertThat(CommandLineRun.of("check", folder.resolve("nothing.jar")).status()).isEqualTo(2);
        Path broken = Files.writeString(folder.resolve("Broken.java"), "class Broken {");
        assertThat(CommandLineRun.of("check", broken).status()).isEqualTo(2);
    }
}
