package brickless.program;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What the finder makes of names; how programs run is tested through the command line. */
class ProgramFinderTest {
    @TempDir Path folder;

    private Program find(String name) throws ProgramException {
        return new ProgramFinder(folder, List.of(), Optional.empty()).find(name);
    }


    @Test
    void closingAProgramRemovesWhatWasCompiled() throws Exception {
        Files.writeString(folder.resolve("Idle.java"), "class Idle { public static void main(String[] a) { } }");
        Path classes;
        try (Program program = find("Idle.java")) {
            classes = program.classPath().get(0);
            assertThat(program.mainClass()).isEqualTo("Idle");
            assertThat(classes.resolve("Idle.class")).exists();
        }
        assertThat(classes).doesNotExist();
    }

    @Test
    void theMainClassOfASourceIsItsOwnEvenBesideOthers() throws Exception {
        Files.createDirectories(folder.resolve("src/a/b"));
        Files.writeString(folder.resolve("src/a/b/Two.java"),
                "package a.b; public class Two { public static void main(String[] a) { One.main(a); } }");
        Files.writeString(folder.resolve("src/a/b/One.java"),
                "package a.b; public class One { public static void main(String[] a) { } }");
        try (Program program = find("src/a/b/Two.java")) {
            assertThat(program.mainClass()).isEqualTo("a.b.Two");
            assertThat(program.simpleName()).isEqualTo("Two");
        }
    }

    @Test
    void compilersMessagesAreLimitedAndInOrder() throws IOException {
        StringBuilder source = new StringBuilder("class Broken {\n");
        for (int i = 0; i < 15; i++) {
            source.append("    int field").append(i).append(" = missing").append(i).append(";\n");
        }
        Files.writeString(folder.resolve("Broken.java"), source.append("}\n"));
        assertThatThrownBy(() -> find("Broken.java")).isInstanceOf(ProgramException.class).satisfies(failure -> {
            List<String> lines = failure.getMessage().lines().toList();
            assertThat(lines).hasSize(11);
            assertThat(lines.get(0)).contains("Broken.java:2: error: cannot find symbol").contains("missing0");
            assertThat(lines.get(10)).isEqualTo("\u2026 and 5 more errors");
        });
    }

    private void write(String name, String text) throws IOException {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        Files.writeString(file, text);
    }

    private static final String MAIN = " { public static void main(String[] a) { new Part().use(); } }";

    /** Two programs, a part of both, and a file that does not compile. */
    private void writeFolderWithAnError() throws IOException {
        write("club/src/a/Part.java", "package a; class Part { void use() { } }");
        write("club/src/a/Race.java", "package a; public class Race" + MAIN);
        write("club/src/a/Broken.java", "package a; class Broken { int i = \"text\"; /* static void main( */ }");
    }

    @Test
    void aProgramBesideABrokenFileIsCompiledAlone() throws Exception {
        writeFolderWithAnError();
        try (Program program = find("club")) {
            assertThat(program.mainClass()).isEqualTo("a.Race");
            assertThat(program.classPath().get(0).resolve("a/Part.class")).exists();
            assertThat(program.remark()).hasValueSatisfying(remark -> assertThat(remark)
                    .startsWith("compiled without the rest of club, which has errors: ")
                    .contains("Broken.java:1: error: incompatible types"));
        }
    }

    @Test
    void besideABrokenFileAMainClassCanBeChosen() throws Exception {
        writeFolderWithAnError();
        write("club/src/b/Race.java", "package b; public class Race { public static void main(String[] a) { } }");
        assertThatThrownBy(() -> find("club")).isInstanceOf(ProgramException.class)
                .hasMessageContaining("Broken.java:1: error: ")
                .hasMessageEndingWith("choose a main class with --main: a.Race, b.Race");
        try (Program program = new ProgramFinder(folder, List.of(), Optional.of("b.Race")).find("club")) {
            assertThat(program.classPath().get(0).resolve("b/Race.class")).exists();
            assertThat(program.classPath().get(0).resolve("a/Race.class")).doesNotExist();
        }
    }

    @Test
    void twoProgramsWithClassesOfTheSameNameCanBeChosenBetween() throws Exception {
        write("club/one/One.java", "class Part { void use() { } } public class One" + MAIN);
        write("club/two/Two.java", "class Part { void use() { } } public class Two" + MAIN);
        try (Program program = new ProgramFinder(folder, List.of(), Optional.of("Two")).find("club")) {
            assertThat(program.mainClass()).isEqualTo("Two");
        }
    }

    @Test
    void ifTheOnlyProgramIsBrokenItsErrorsAreTold() throws IOException {
        write("club/Race.java", "public class Race { public static void main(String[] a) { drive(); } }");
        assertThatThrownBy(() -> find("club")).isInstanceOf(ProgramException.class)
                .hasMessageContaining("Race.java:1: error: ").hasMessageContaining("drive");
    }

    @Test
    void jarsInTheFolderAreLibraries() throws Exception {
        write("library/tools/Tool.java", "package tools; public class Tool { }");
        compile(folder.resolve("library"), "library/tools/Tool.java");
        write("club/src/Race.java", "public class Race { public static void main(String[] a) { new tools.Tool(); } }");
        Files.createDirectories(folder.resolve("club/lib"));
        Path jar = folder.resolve("club/lib/tools.jar");
        try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(jar))) {
            out.putNextEntry(new JarEntry("tools/Tool.class"));
            out.write(Files.readAllBytes(folder.resolve("library/tools/Tool.class")));
        }
        try (Program program = find("club")) {
            assertThat(program.classPath()).hasSize(2).last().isEqualTo(jar);
        }
        compile(folder.resolve("club"), "club/src/Race.java", "-cp", jar.toString());
        Files.delete(folder.resolve("club/src/Race.java"));
        try (Program program = find("club")) {
            assertThat(program.classPath()).as("also beside compiled classes").hasSize(2).last().isEqualTo(jar);
        }
    }

    private void compile(Path target, String source, String... options) {
        List<String> words = new ArrayList<>(
                List.of("--release", "8", "-nowarn", "-Xlint:-options", "-d", target.toString()));
        words.addAll(List.of(options));
        words.add(folder.resolve(source).toString());
        assertThat(ToolProvider.getSystemJavaCompiler().run(null, null, null, words.toArray(String[]::new))).isZero();
    }

    @Test
    void aMissingLibraryIsToldOnce() throws IOException {
        write("Race.java", "import org.far.away.Thing; import org.far.away.more.*;\npublic class Race { Thing thing; "
                + "public static void main(String[] a) { } }");
        assertThatThrownBy(() -> find("Race.java")).hasMessageContaining("error: package org.far.away does not exist")
                .hasMessageContaining("Not found: org.far.away, org.far.away.more. Give the folder")
                .hasMessageEndingWith("--classpath.");
    }

    @Test
    void aProgramForTheNxtIsToldSo() throws IOException {
        write("Race.java", "import lejos.nxt.Motor; import lejos.util.Delay;\npublic class Race { public static void "
                + "main(String[] a) { Motor.A.forward(); } }");
        assertThatThrownBy(() -> find("Race.java")).hasMessageContaining(
                "It is written for leJOS on the NXT or RCX; Brickless runs programs for leJOS EV3")
                .satisfies(failure -> assertThat(failure.getMessage().split("It is written")).hasSize(2));
    }

    @Test
    void aClassOfLejosThatIsNotHereIsNamedInFull() throws IOException {
        write("Race.java", "import lejos.hardware.sensor.HiTechnicGyro; import lejos.hardware.gps.GPS;\n"
                + "public class Race { HiTechnicGyro gyro; public static void main(String[] a) { } }");
        assertThatThrownBy(() -> find("Race.java"))
                .hasMessageContaining("Not in Brickless' leJOS: lejos.hardware.gps, "
                        + "lejos.hardware.sensor.HiTechnicGyro. sim/docs/COMPATIBILITY.md");
    }
}
