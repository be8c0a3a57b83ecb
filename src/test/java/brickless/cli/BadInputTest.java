package brickless.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Bad input: one located line for the user, exit status 2, and nothing written. */
class BadInputTest {
    private static final String PROGRAM = "public class Idle { public static void main(String[] args) { } }";
    private static final String CHASSIS = "<rect data-part='chassis' x='-80' y='-60' width='160' height='120' "
            + "data-mass-kg='0.8'/>";

    @TempDir Path folder;
    private Path idle;
    private Path out;

    @BeforeEach
    void writeAProgram() {
        idle = write("Idle.java", PROGRAM);
        out = folder.resolve("out");
    }

    private Path write(String name, String text) {
        try {
            Path file = folder.resolve(name);
            Files.createDirectories(file.getParent());
            return Files.writeString(file, text);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private String refused(Object... words) {
        List<Object> all = new ArrayList<>(List.of("run"));
        all.addAll(List.of(words));
        all.addAll(List.of("--out", out));
        CommandLineRun run = CommandLineRun.of(all.toArray());
        assertThat(run.status()).as(run.err()).isEqualTo(2);
        assertThat(run.out()).isEmpty();
        assertThat(run.err()).as("one line").hasLineCount(1).startsWith("brickless run: ");
        assertThat(out).doesNotExist();
        return run.err().strip();
    }

    private Path world(String content) {
        return write("w.svg", "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 1000 1000'>\n" + content
                + "\n</svg>\n");
    }

    private Path robot(String content) {
        return write("r.svg", "<svg xmlns='http://www.w3.org/2000/svg' viewBox='-100 -100 200 200'>\n" + content
                + "\n</svg>\n");
    }

    @Test
    void missingProgram() {
        assertThat(refused("NoSuch.java")).contains("NoSuch.java: no such program");
    }

    @Test
    void missingClass() {
        assertThat(refused("no.such.Program")).contains("no.such.Program: no such program");
    }

    @Test
    void classWithoutMain() {
        assertThat(refused("java.lang.String")).endsWith(
                "class java.lang.String has no public static void main(String[])");
    }

    @Test
    void programThatDoesNotCompile() {
        Path broken = write("Broken.java", "public class Broken {\n    public static void main(String[] args) {\n     "
                + "   int x = \"text\";\n    }\n}\n");
        assertThat(refused(broken)).endsWith("Broken.java:3: error: incompatible types: java.lang.String cannot be "
                + "converted to int");
    }

    @Test
    void programWithAClassThatLeJosDoesNotHave() {
        Path broken = write("Broken.java", "import lejos.hardware.Teleporter;\nclass Broken { public static void "
                + "main(String[] a) { } }\n");
        CommandLineRun run = CommandLineRun.of("run", broken, "--out", out);
        assertThat(run.status()).isEqualTo(2);
        assertThat(run.err().lines()).hasSize(2).first().asString().contains("Broken.java:1: error: cannot find symbol")
                .contains("class Teleporter");
        assertThat(run.err()).contains("Not in Brickless' leJOS: lejos.hardware.Teleporter.");
    }

    @Test
    void programWithoutMain() {
        assertThat(refused(write("Parts.java", "class Parts { }")))
                .endsWith("Parts.java: no class with a public static void main(String[])");
    }

    @Test
    void severalMainsAndNoneChosen() {
        write("several/One.java", "class One { public static void main(String[] a) { } }");
        write("several/Two.java", "class Two { public static void main(String[] a) { } }");
        assertThat(refused(folder.resolve("several")))
                .endsWith("several main classes, choose one with --main: One, Two");
    }

    @Test
    void chosenMainThatIsNone() {
        assertThat(refused(idle, "--main", "Other"))
                .endsWith("class Other has no public static void main(String[]); main classes there: Idle");
    }

    @Test
    void fileThatIsNoProgram() {
        assertThat(refused(write("notes.txt", "hello"))).contains("notes.txt: not a program: allowed are");
    }

    @Test
    void jarThatIsNone() {
        assertThat(refused(write("robot.jar", "hello"))).contains("robot.jar: cannot be read");
    }

    @Test
    void classFileThatIsNone() {
        assertThat(refused(write("Robot.class", "hello"))).endsWith("Robot.class: not a class file");
    }

    @Test
    void classPathEntryThatIsMissing() {
        assertThat(refused(idle, "--classpath", "no/such.jar")).endsWith("no/such.jar: no such class path entry");
    }

    @Test
    void worldThatIsMissing() {
        assertThat(refused(idle, "--world", "no-such"))
                .contains("no-such: no such world: neither a file nor one of pen, ");
    }

    @Test
    void worldThatIsNotXml() {
        assertThat(refused(idle, "--world", write("w.svg", "walls everywhere\n"))).contains("w.svg:1: ");
    }

    @Test
    void robotThatIsMissing() {
        assertThat(refused(idle, "--robot", "no-such"))
                .contains("no-such: no such robot: neither a file nor one of educator, ");
    }

    @Test
    void unknownPart() {
        assertThat(refused(idle, "--robot", robot(CHASSIS
                + "\n<rect id='x' data-part='rocket' width='9' height='9'/>")))
                .contains("r.svg:3: ").contains("rocket").contains("chassis, wheel, caster, sensor");
    }

    @Test
    void portUsedTwice() {
        String wheel = "<rect id='%s' data-part='wheel' data-port='B' data-motor='large' data-diameter-mm='56' "
                + "x='-28' y='%d' width='56' height='20'/>";
        assertThat(refused(idle, "--robot", robot(CHASSIS + "\n" + wheel.formatted("one", -80) + "\n"
                + wheel.formatted("two", 60))))
                .contains("r.svg:4: ").contains("two").contains("B");
    }

    @Test
    void wheelWithoutSize() {
        assertThat(refused(idle, "--robot", robot(CHASSIS
                + "\n<rect id='w' data-part='wheel' data-port='B' data-motor='large' "
                + "data-diameter-mm='0' x='-28' y='-80' width='56' height='20'/>"))).contains("r.svg:3: ")
                .contains("data-diameter-mm");
    }

    @Test
    void robotInsideAWall() {
        Path inside = world("<rect id='block' data-solid='fixed' x='300' y='300' width='400' height='400'/>\n"
                + "<g data-robot='robot' transform='translate(500 500)'/>");
        assertThat(refused(idle, "--world", inside)).contains("w.svg").contains("inside the obstacle block");
    }

    @Test
    void negativeTime() {
        assertThat(refused(idle, "--for=-5s")).contains("--for").contains("-5s").contains("500ms, 60s, 2m");
    }

    @Test
    void timeWithoutUnit() {
        assertThat(refused(idle, "--for", "60")).contains("--for").contains("500ms, 60s, 2m");
    }

    @Test
    void unknownOption() {
        assertThat(refused(idle, "--wrld", "pen")).contains("unknown option --wrld; ").contains("--world");
    }

    @Test
    void seedThatIsNoNumber() {
        assertThat(refused(idle, "--seed", "lucky")).contains("--seed").contains("lucky");
    }

    @Test
    void unknownButtonPolicy() {
        assertThat(refused(idle, "--buttons", "maybe")).contains("'maybe' is no button policy; allowed: auto, none");
    }

    @Test
    void unknownBackend() {
        assertThat(refused(idle, "--backend", "steam")).contains("allowed: auto, threads, continuation");
    }

    @Test
    void missingStimuli() {
        assertThat(refused(idle, "--stimuli", folder.resolve("none.txt"))).contains("none.txt: cannot be read");
    }

    @Test
    void stimulusThatIsUnknown() {
        assertThat(refused(idle, "--stimuli", write("s.txt", "# a comment\n1s press ENTER 200ms\n2s kick S1 1s\n")))
                .contains("s.txt:3: unknown stimulus 'kick'");
    }

    @Test
    void stimulusForSomethingThatIsNotThere() {
        assertThat(refused(idle, "--stimuli", write("s.txt", "1s remove piano\n"))).contains("'remove piano'")
                .contains("crate, brick");
    }

    @Test
    void stimulusForAWall() {
        assertThat(refused(idle, "--stimuli", write("s.txt", "1s move fence 500,500 0\n")))
                .contains("nothing movable named fence");
    }

    @Test
    void unknownZone() {
        assertThat(refused(idle, "--until", "zone:gaol"))
                .endsWith("zone:gaol: pen has no such zone; its zones are goal");
    }

    @Test
    void zoneOfAWorldWithoutZones() {
        assertThat(refused(idle, "--world", world("<rect width='9' height='9'/>"), "--until", "zone:goal"))
                .endsWith("has no such zone; it has no zones");
    }

    @Test
    void goalThatIsNone() {
        assertThat(refused(idle, "--until", "goal")).contains("'goal' is no goal; allowed: zone:NAME, exit");
    }

    @Test
    void folderThatIsAFile() {
        Path file = write("results", "already here");
        CommandLineRun run = CommandLineRun.of("run", idle, "--out", file);
        assertThat(run.status()).isEqualTo(2);
        assertThat(run.err()).hasLineCount(1).contains("results: cannot be made a folder");
        assertThat(file).hasContent("already here");
    }

    @Test
    void noCommand() {
        CommandLineRun run = CommandLineRun.of();
        assertThat(run.status()).isEqualTo(2);
        assertThat(run.err()).hasLineCount(1).contains("which command? one of ").contains("run").contains("explore");
    }

    @Test
    void unknownCommand() {
        CommandLineRun run = CommandLineRun.of("fly", idle);
        assertThat(run.status()).isEqualTo(2);
        assertThat(run.err()).hasLineCount(1).contains("fly");
    }

    @Test
    void noProgram() {
        CommandLineRun run = CommandLineRun.of("run");
        assertThat(run.status()).isEqualTo(2);
        assertThat(run.err()).hasLineCount(1).contains("PROGRAM");
    }
}
