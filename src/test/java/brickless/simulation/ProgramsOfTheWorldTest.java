package brickless.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import brickless.program.Program;
import brickless.world.DescriptionException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Worlds that name the programs of their robots, relative to the world's file. */
class ProgramsOfTheWorldTest {
    @TempDir Path folder;

    @BeforeEach
    void writePrograms() throws IOException {
        write("first/FirstToLeave.java", "import lejos.hardware.motor.Motor; public class FirstToLeave { public static "
                + "void main(String[] args) {"
                + " Motor.A.rotate(360, true); Motor.D.rotate(360); System.out.println(\"first\"); } }");
        write("second/LastToLeave.java",
                "import lejos.hardware.motor.Motor; import lejos.utility.Delay; public class LastToLeave {"
                + " public static void main(String[] args) { Delay.msDelay(4000); Motor.B.rotate(360, true); "
                + "Motor.C.rotate(360); System.out.println(\"last\"); } }");
        write("second/Breaks.java",
                "public class Breaks { public static void main(String[] args) { int[] none = {}; none[1] = 0; } }");
    }

    private void write(String name, String text) throws IOException {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        Files.writeString(file, text);
    }

    private Run run(String one, String other) throws IOException, DescriptionException {
        Path world = Files.writeString(folder.resolve("arena.svg"),
                "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 2000 2000'>"
                + "<g data-robot='one' data-program='" + one + "' transform='translate(500 500)'/>"
                + "<g data-robot='other' data-program='" + other + "' transform='translate(500 1500)'/></svg>");
        SimulationSettings settings = SimulationSettings.builder(new Library(folder).world(world.toString()))
                .worldFile(world.toString()).build();
        Run run = new Simulation(settings).start(Program.unknown());
        run.toEnd();
        return run;
    }

    @Test
    void eachRobotRunsItsOwnAndIsFittedToIt() throws Exception {
        Run run = run("first", "second/LastToLeave.java");
        assertThat(run.outcome().exitStatus()).contains(0);
        assertThat(run.time().toMillis()).as("the last program ends the run").isBetween(5000L, 7000L);
        assertThat(run.robots().get(0).printedLines()).containsExactly("first");
        assertThat(run.robots().get(1).printedLines()).containsExactly("last");
        assertThat(run.robots()).allSatisfy(robot -> assertThat(robot.distanceMetres()).isCloseTo(0.176, within(0.02)));
        assertThat(run.report().notes()).filteredOn(note -> note.startsWith("robot fitted")).satisfiesExactly(
                note -> assertThat(note).contains("left wheel on A", "right wheel on D"),
                note -> assertThat(note).contains("left wheel on B", "right wheel on C"));
    }

    @Test
    void whatWasCompiledForThemIsRemoved() throws Exception {
        run("first/FirstToLeave.java", "second/LastToLeave.java");
        assertThatThrownBy(() -> run("first/FirstToLeave.java", "second/Missing.java"))
                .isInstanceOf(SetupException.class).hasMessageContaining("second/Missing.java: no such program");
        try (Stream<Path> left = Files.list(Path.of(System.getProperty("java.io.tmpdir")))) {
            List<Path> kept = left.filter(each -> each.getFileName().toString().startsWith("brickless-classes"))
                    .filter(each -> Files.exists(each.resolve("FirstToLeave.class"))
                            || Files.exists(each.resolve("LastToLeave.class"))).toList();
            assertThat(kept).isEmpty();
        }
    }

    @Test
    void anExceptionOfOneFailsTheRunWhenAllHaveEnded() throws Exception {
        Run run = run("second/Breaks.java", "second/LastToLeave.java");
        assertThat(run.outcome().kind()).isEqualTo("failed");
        assertThat(run.outcome().error().orElseThrow()).contains("ArrayIndexOutOfBoundsException", "Breaks.java:1");
        assertThat(run.robots().get(1).printedLines()).as("the other goes on").containsExactly("last");
    }
}
