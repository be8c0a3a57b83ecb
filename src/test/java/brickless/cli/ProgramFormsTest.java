package brickless.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.jar.Attributes;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** All the ways to name a program. */
class ProgramFormsTest {
    @TempDir Path folder;

    private Path write(String name, String text, Charset charset) throws IOException {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        return Files.writeString(file, text, charset);
    }

    private Path write(String name, String text) throws IOException {
        return write(name, text, StandardCharsets.UTF_8);
    }

    private String printed(Object... words) {
        List<Object> all = new ArrayList<>(List.of("run"));
        all.addAll(List.of(words));
        all.addAll(List.of("--out", folder.resolve("out")));
        CommandLineRun run = CommandLineRun.of(all.toArray());
        assertThat(run.status()).as(run.err()).isZero();
        try {
            return Files.readString(folder.resolve("out/console.txt")).strip();
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    /** Two classes of one package, compiled. */
    private Path classes() throws IOException {
        Path main = write("src/fleet/Scout.java", "package fleet;\npublic class Scout { public static void "
                + "main(String[] a) { System.out.println(Map.TEXT); } }");
        Path part = write("src/fleet/Map.java", "package fleet;\nclass Map { static final String TEXT = \"scout\" + "
                + "1; }");
        Path target = Files.createDirectories(folder.resolve("classes"));
        int status = ToolProvider.getSystemJavaCompiler().run(null, null, null, "--release", "8", "-nowarn",
                "-Xlint:-options", "-d", target.toString(),
                main.toString(), part.toString());
        assertThat(status).isZero();
        return target;
    }

    private Path jar(String mainClass) throws IOException {
        Manifest manifest = new Manifest();
        manifest.getMainAttributes().put(Attributes.Name.MANIFEST_VERSION, "1.0");
        if (mainClass != null) {
            manifest.getMainAttributes().put(Attributes.Name.MAIN_CLASS, mainClass);
        }
        Path classes = classes();
        Path jar = folder.resolve("fleet.jar");
        try (OutputStream file = Files.newOutputStream(jar); JarOutputStream out = new JarOutputStream(file, manifest);
                Stream<Path> files = Files.walk(classes)) {
            for (Path each : files.filter(Files::isRegularFile).sorted().toList()) {
                out.putNextEntry(new JarEntry(classes.relativize(each).toString()));
                Files.copy(each, out);
            }
        }
        return jar;
    }

    @Test
    void sourceFileInItsPackageWithSiblings() throws IOException {
        classes();
        assertThat(printed(folder.resolve("src/fleet/Scout.java"))).isEqualTo("scout1");
    }

    @Test
    void directoryOfSources() throws IOException {
        classes();
        assertThat(printed(folder.resolve("src"))).isEqualTo("scout1");
    }

    @Test
    void directoryOfClasses() throws IOException {
        assertThat(printed(classes())).isEqualTo("scout1");
    }

    @Test
    void classFile() throws IOException {
        assertThat(printed(classes().resolve("fleet/Scout.class"))).isEqualTo("scout1");
    }

    @Test
    void classNameOnAClassPath() throws IOException {
        assertThat(printed("fleet.Scout", "--classpath", classes())).isEqualTo("scout1");
    }

    @Test
    void jarWithMainClass() throws IOException {
        assertThat(printed(jar("fleet.Scout"))).isEqualTo("scout1");
    }

    @Test
    void jarWithoutMainClass() throws IOException {
        assertThat(printed(jar(null))).isEqualTo("scout1");
    }

    @Test
    void librariesFromTheClassPath() throws IOException {
        Path user = write("User.java", "import fleet.Scout;\npublic class User { public static void main(String[] a) "
                + "{ Scout.main(a); } }");
        assertThat(printed(user, "--classpath", jar(null))).isEqualTo("scout1");
    }

    @Test
    void oneOfSeveralMains() throws IOException {
        write("two/One.java", "class One { public static void main(String[] a) { System.out.println(1); } }");
        write("two/Two.java", "class Two { public static void main(String[] a) { System.out.println(2); } }");
        assertThat(printed(folder.resolve("two"), "--main", "Two")).isEqualTo("2");
        assertThat(printed(folder.resolve("two/One.java"))).isEqualTo("1");
    }

    @Test
    void sourceInLatin1WithUmlauts() throws IOException {
        Path file = write("Gruss.java", "// f\u00fcr alle\npublic class Gruss { public static void main(String[] a) { "
                + "System.out.println(\"Gr\u00fc\u00dfe\"); } }",
                StandardCharsets.ISO_8859_1);
        assertThat(printed(file)).isEqualTo("Gr\u00fc\u00dfe");
    }

    @Test
    void sourceWithByteOrderMark() throws IOException {
        assertThat(printed(write("Marked.java", "\uFEFFclass Marked { public static void main(String[] a) { "
                + "System.out.println(\"\u00e4\"); } }"))).isEqualTo("\u00e4");
    }

    @Test
    void sourceForJava17() throws IOException {
        assertThat(printed(write("Modern.java", """
                import java.util.List;
                public class Modern {
                    record Leg(int cm) {}
                    public static void main(String[] a) {
                        var legs = List.of(new Leg(3), new Leg(4));
                        int sum = legs.stream().mapToInt(Leg::cm).sum();
                        String size = switch (sum) { case 7 -> "seven"; default -> "?"; };
                        System.out.println(size + " " + legs.get(0));
                    }
                }
                """))).isEqualTo("seven Leg[cm=3]");
    }

    @Test
    void sourceForJava8WithYieldAsAMethod() throws IOException {
        assertThat(printed(write("Old.java", """
                public class Old extends Thread {
                    int turns;
                    public void run() {
                        while (turns < 3) { turns++; yield(); }
                        System.out.println("turns " + turns);
                    }
                    public static void main(String[] a) { new Old().start(); }
                }
                """))).isEqualTo("turns 3");
    }

    @Test
    void classOfTheApplication() {
        assertThat(printed("programs.passing.text.Numbers")).isNotEmpty();
    }

    @Test
    void mainOfASuperclass() throws IOException {
        write("inherit/Base.java", "class Base { public static void main(String[] a) { System.out.println(\"base\"); "
                + "} }");
        Path derived = write("inherit/Derived.java", "public class Derived extends Base { }");
        assertThat(printed(derived)).isEqualTo("base");
    }
}
