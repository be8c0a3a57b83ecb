package brickless.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import brickless.program.ProgramException;
import brickless.simulation.ExamplePrograms.Trace;
import brickless.world.DescriptionException;
import brickless.world.World;
import brickless.world.svg.SvgWorldReader;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Every example program, as a whole, does in its world what it says. */
class ExampleProgramsTest {
    /** Distance of the educator's ultrasonic sensor from its axle, metres; where it looks from on the drawing. */
    private static final double EAR_METRES = 0.078;

    @TempDir Path folder;
    private static ExamplePrograms programs;

    @BeforeAll
    static void compile() throws ProgramException {
        programs = ExamplePrograms.compiled();
    }

    @AfterAll
    static void removeClasses() {
        programs.close();
    }

    private Run run(String main, SimulationSettings.Builder settings, int seconds) {
        Run run = new Simulation(settings.limit(Duration.ofSeconds(seconds)).out(Optional.of(folder)).build())
                .start(programs.program(main));
        run.toEnd();
        return run;
    }

    private Run run(String main, int seconds) throws DescriptionException {
        return run(main, ExamplePrograms.settings(ExamplePrograms.worldOf(main)), seconds);
    }

    private static List<Stimulus> stimuli(String text) throws DescriptionException {
        return StimuliReader.readText("stimuli", text);
    }

    private static World world(String content) throws DescriptionException {
        return SvgWorldReader.readText("test.svg", "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 4000 2000'>"
                + content + "</svg>");
    }

    private static void staysInThePen(Trace trace) {
        assertThat(Arrays.stream(trace.numbers("sample", "x")).allMatch(x -> x > 0.03 && x < 1.97))
                .as("x of all samples inside").isTrue();
        assertThat(Arrays.stream(trace.numbers("sample", "y")).allMatch(y -> y > 0.03 && y < 1.47))
                .as("y of all samples inside").isTrue();
    }

    /** Times at which behaviours became active, as "number" strings in order, none left out. */
    private static List<Integer> active(Trace trace) {
        return Arrays.stream(trace.numbers("active", "behaviour")).mapToObj(number -> (int) number)
                .filter(number -> number >= 0).toList();
    }

    @Test
    void theExplorerCruisesAvoidsAndBacksOff() throws DescriptionException {
        Run run = run("explorer.Explorer", 60);
        assertThat(run.outcome().kind()).isEqualTo("time-limit");
        assertThat(run.robot().distanceMetres()).isBetween(3.0, 15.0);
        Trace trace = Trace.in(folder);
        staysInThePen(trace);
        assertThat(trace.of("arbitrator")).singleElement().asString()
                .contains("[\"explorer.Cruise\",\"explorer.AvoidWall\",\"explorer.PauseOnGreen\","
                        + "\"explorer.BackOff\",\"explorer.Quit\"]");
        List<Integer> active = active(trace);
        assertThat(active.get(0)).as("cruises first").isZero();
        assertThat(active).contains(1, 3).doesNotContain(4);
        assertThat(trace.of("wants")).as("somebody asks before each change")
                .hasSizeGreaterThanOrEqualTo(active.size() / 2);
        assertThat(run.robot().screenText()).contains("Explorer").contains("Walls ").contains("Bumps ");
        assertThat(run.collisions()).isPositive();
        assertThat(run.robot().printedLines()).containsExactly("Arbitrator created");
    }

    @Test
    void theExplorerPausesOnGreen() throws DescriptionException {
        World green = world("<rect x='1000' y='0' width='400' height='2000' fill='#2f9e57'/><g data-robot='robot' "
                + "transform='translate(500 1000)'/>");
        Run run = run("explorer.Explorer", SimulationSettings.builder(green).robot(educator()), 12);
        Trace trace = Trace.in(folder);
        assertThat(active(trace)).contains(2);
        assertThat(run.robot().screenText()).contains("Green 1");
        assertThat(trace.of("sound")).as("three tones upwards").hasSizeGreaterThanOrEqualTo(3);
        assertThat(trace.numbers("led", "pattern")).startsWith(1, 4, 1);
    }

    private static brickless.world.RobotModel educator() throws DescriptionException {
        return new Library(Path.of("no-files-here")).robot("educator");
    }

    @Test
    void escapeEndsTheExplorer() throws DescriptionException {
        Run run = run("explorer.Explorer", ExamplePrograms.settings("pen").stimuli(stimuli("6s press ESCAPE 500ms")),
                30);
        assertThat(run.outcome()).isEqualTo(new Outcome("exited", Optional.of(0), run.outcome().timeNanos(),
                Optional.empty()));
        assertThat(run.time()).isBetween(Duration.ofSeconds(6), Duration.ofMillis(8500));
        Trace trace = Trace.in(folder);
        assertThat(active(trace)).endsWith(4);
        assertThat(trace.of("key")).first().asString()
                .contains("\"key\":\"ESCAPE\",\"down\":true,\"cause\":\"stimulus\"");
        assertThat(run.robot().ledPattern()).isZero();
    }

    @Test
    void theBumperCarWaitsForAKeyAndTurnsAtWalls() throws DescriptionException {
        Run run = run("bumper.BumperCar", 40);
        assertThat(run.outcome().kind()).isEqualTo("time-limit");
        assertThat(run.robot().printedLines()).containsExactly("Press any key", "Arbitrator created");
        Trace trace = Trace.in(folder);
        staysInThePen(trace);
        assertThat(trace.of("key")).first().asString().contains("\"key\":\"ENTER\",\"down\":true,\"cause\":\"auto\"");
        assertThat(run.report().notes()).anyMatch(note ->
                note.contains("keys pressed for the program while it waited: ENTER "));
        assertThat(active(trace)).startsWith(0, 1, 0).doesNotContain(2);
        assertThat(run.robot().distanceMetres()).isGreaterThan(2);
    }

    @Test
    void aKeyEndsTheBumperCarWhileItIsAsked() throws DescriptionException {
        Run run = run("bumper.BumperCar", ExamplePrograms.settings("pen")
                .stimuli(stimuli("500ms press ENTER 200ms\n5s press LEFT 1500ms")), 20);
        assertThat(run.outcome().kind()).isEqualTo("exited");
        assertThat(run.time()).isBetween(Duration.ofSeconds(5), Duration.ofSeconds(7));
        assertThat(Trace.in(folder).of("key").toString()).doesNotContain("\"auto\"");
    }

    @Test
    void theWandererTurnsWithoutLoopsInItsActions() throws DescriptionException {
        Run run = run("wanderer.Wanderer", ExamplePrograms.settings("pen").stimuli(stimuli("40s press ESCAPE 1s")), 60);
        assertThat(run.outcome().kind()).isEqualTo("exited");
        Trace trace = Trace.in(folder);
        staysInThePen(trace);
        assertThat(active(trace)).startsWith(0, 1).endsWith(2);
        assertThat(trace.lines()).as("no flood of events").hasSizeLessThan(3000);
        assertThat(run.robot().distanceMetres()).isGreaterThan(2);
    }

    @Test
    void busyWaitingComesBackToTheStart() throws DescriptionException {
        Run run = run("busywait.BusyWait", 20);
        assertThat(run.outcome().exitStatus()).contains(0);
        assertThat(run.time()).as("four turns of the wheels at a turn per second").isBetween(Duration.ofSeconds(4),
                Duration.ofSeconds(6));
        String[] counts = run.robot().printedLines().get(0).split(" ");
        assertThat(Integer.parseInt(counts[0])).isCloseTo(0, within(3));
        assertThat(Integer.parseInt(counts[1])).isCloseTo(0, within(3));
        assertThat(run.robot().screenText()).containsPattern("yielding: 7[12]\\d\\s")
                .containsPattern("spinning: -?\\d");
        assertThat(run.robot().distanceMetres()).as("two turns of 56 mm tyres there and back")
                .isCloseTo(4 * Math.PI * 0.056, within(0.03));
        assertThat(run.robot().xMetres()).isCloseTo(0.33, within(0.01));
    }

    @Test
    void theWallIsNotHit() throws DescriptionException {
        World walled = world("<rect data-solid='fixed' data-height-mm='200' x='2000' y='0' width='100' height='2000'/>"
                + "<g data-robot='robot' transform='translate(500 1000)'/>");
        Run run = run("wallstop.WallStop", SimulationSettings.builder(walled).robot(educator()), 20);
        assertThat(run.outcome().exitStatus()).contains(0);
        assertThat(run.robot().xMetres()).isCloseTo(2.0 - 0.30 - EAR_METRES, within(0.04));
        assertThat(run.robot().headingDegrees()).isCloseTo(0, within(3.0));
        assertThat(run.collisions()).isZero();
        assertThat(run.robot().printedLines()).containsExactly("stopped");
        assertThat(Trace.in(folder).of("sound")).isNotEmpty();
    }

    @Test
    void sensorThreadsShareWhatTheyMeasure() throws DescriptionException {
        Run run = run("sensorthreads.SensorThreads", 60);
        assertThat(run.outcome().exitStatus()).contains(0);
        assertThat(run.robot().printedLines()).containsExactly("legs 4");
        assertThat(run.report().contextSwitches()).as("threads take turns").isGreaterThan(100);
        staysInThePen(Trace.in(folder));
    }

    @Test
    void theSquareEndsWhereItBegan() throws DescriptionException {
        World open = world("<g data-robot='robot' transform='translate(1000 1000)'/>");
        Run run = run("square.Square", SimulationSettings.builder(open).robot(educator()).ideal(true), 60);
        assertThat(run.outcome().exitStatus()).contains(0);
        assertThat(run.robot().distanceMetres()).isCloseTo(2.0, within(0.05));
        assertThat(run.robot().xMetres()).isCloseTo(1.0, within(0.05));
        assertThat(run.robot().yMetres()).isCloseTo(1.0, within(0.05));
        assertThat(run.robot().headingDegrees()).as("four right turns").isCloseTo(360, within(8.0));
        assertThat(run.robot().screenText()).contains("side 4").containsPattern("\\d\\d s");
    }

    @Test
    void theLineIsFollowedAllAround() throws DescriptionException {
        Run run = run("linefollower.LineFollower", 90);
        assertThat(run.outcome().kind()).isEqualTo("time-limit");
        Trace trace = Trace.in(folder);
        assertThat(trace.of("zone").stream().filter(line -> line.contains("\"entered\":true"))).as("laps begun")
                .hasSizeGreaterThanOrEqualTo(2);
        assertThat(run.robot().distanceMetres()).isGreaterThan(7);
    }
}
