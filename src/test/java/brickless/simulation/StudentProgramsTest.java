package brickless.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import brickless.world.DescriptionException;
import brickless.world.World;
import brickless.world.svg.SvgWorldReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import programs.students.Dashboard;
import programs.students.DataLogger;
import programs.students.GyroSquare;
import programs.students.KeyDancer;
import programs.students.KeyboardReader;
import programs.students.Patrol;
import programs.students.PidFollower;
import programs.students.Pong;
import programs.students.RemoteCar;
import programs.students.RobotMenu;
import programs.students.StoredSettings;
import programs.students.Telemetry;
import programs.students.TuneBox;
import programs.students.WavMaker;

/** Whole programs in the styles of students do what they would do on a brick. */
class StudentProgramsTest {
    private static final Library LIBRARY = new Library(Path.of("no-files-here"));

    @TempDir Path folder;

    private Run run(Class<?> program, String world, String robot, long seed, String... stimuli)
            throws DescriptionException {
        return run(program, LIBRARY.world(world), robot, seed, stimuli);
    }

    private Run run(Class<?> program, World world, String robot, long seed, String... stimuli)
            throws DescriptionException {
        SimulationSettings settings = SimulationSettings.builder(world).robot(LIBRARY.robot(robot)).seed(seed)
                .stimuli(StimuliReader.readText("stimuli", String.join("\n", stimuli)))
                .limit(Duration.ofSeconds(60)).out(Optional.of(folder)).build();
        Run run = new Simulation(settings).start(program);
        run.toEnd();
        return run;
    }

    private List<String> printedBy(Class<?> program, String... stimuli) throws DescriptionException {
        Run run = run(program, "pen", "educator", 1, stimuli);
        assertThat(run.outcome().exitStatus()).as(run.outcome() + " " + run.robot().printedLines()).contains(0);
        return run.robot().printedLines();
    }

    @Test
    void aMenuIsSteppedThroughWithKeys() throws DescriptionException {
        assertThat(printedBy(RobotMenu.class, "1s press ENTER 200ms", "2s press DOWN 200ms", "3s press ENTER 200ms",
                "4s press ENTER 200ms", "5s press DOWN 200ms", "6s press ENTER 200ms", "10s press UP 200ms",
                "11s press UP 200ms", "12s press ENTER 200ms", "13s press ESCAPE 200ms"))
                .containsExactly("same voltage", "wiggled to 0 and 0", "chose -1 after 2 beeps");
    }

    @Test
    void aTunePlaysBesideBlinkingLights() throws DescriptionException {
        assertThat(printedBy(TuneBox.class)).containsExactly("volume 40", "quarters 15", "blinks 8", "alive false");
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void aLineIsFollowedWithAllThreeTerms(long seed) throws DescriptionException {
        Run run = run(PidFollower.class, "line-loop", "educator", seed);
        assertThat(run.outcome().exitStatus()).contains(0);
        assertThat(run.robot().distanceMetres()).isGreaterThan(1.0);
        assertThat(number(run, "steps")).isBetween(1000, 3000);
        assertThat(number(run, "worst")).as("percent of reflection away from the edge").isLessThan(40);
    }

    private static int number(Run run, String name) {
        return run.robot().printedLines().stream().filter(line -> line.startsWith(name + " ")).findFirst()
                .map(line -> Integer.parseInt(line.substring(name.length() + 1))).orElseThrow();
    }

    @Test
    void aCarObeysTheRemoteControl() throws DescriptionException {
        Run run = run(RemoteCar.class, "pen", "medium-turret", 1, "1s remote 1 BOTH_TOP 1s",
                "3s remote 1 BOTH_LEFT 500ms", "5s remote 1 BEACON 500ms");
        assertThat(run.outcome().exitStatus()).contains(0);
        assertThat(run.robot().printedLines())
                .containsExactly("code 0", "code 5", "code 0", "code 10", "code 0", "code 9");
        assertThat(run.robot().distanceMetres()).as("a second at 400 degrees per second").isBetween(0.1, 0.3);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void theGyroMeasuresTheCornersOfASquare(long seed) throws DescriptionException {
        Run run = run(GyroSquare.class, "pen", "educator", seed);
        assertThat(run.outcome().exitStatus()).as(run.outcome().toString()).contains(0);
        assertThat(run.robot().printedLines()).containsExactly("corner 1 at 90", "corner 2 at 180", "corner 3 at 270",
                "corner 4 at 360");
        assertThat(run.robot().distanceMetres()).isCloseTo(4 * 0.293, within(0.1));
    }

    @Test
    void aSoundFileThatTheProgramMadePlaysForItsLength() throws DescriptionException {
        assertThat(printedBy(WavMaker.class))
                .containsExactly("result 0", "hundredths 75", "bytes 6044", "removed true", "missing -9", "raw 2000");
    }

    @Test
    void filesStayInTheFolderWhereTheSimulatorRuns() throws DescriptionException {
        assertThat(printedBy(StoredSettings.class))
                .containsExactly("no settings yet", "found true", "speed 300", "degrees 360",
                "folder " + Path.of("").toAbsolutePath(), "pilot 4.0 18.0 false");
        assertThat(Files.exists(Path.of("student-settings.properties"))).as("the program removed it").isFalse();
    }

    @Test
    void valuesGoThroughASocket() throws DescriptionException {
        assertThat(printedBy(Telemetry.class))
                .containsExactly("listener: end of data", "hello from the brick", "values 10");
    }

    @Test
    void aLogIsWrittenAndRead() throws DescriptionException {
        World wall = SvgWorldReader.readText("wall.svg",
                "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 2000 1000'>"
                + "<rect data-solid='fixed' x='1500' y='0' width='50' height='1000'/>"
                + "<g data-robot='robot' transform='translate(300 500)'/></svg>");
        List<String> printed = run(DataLogger.class, wall, "educator", 1).robot().printedLines();
        assertThat(printed.get(0)).isEqualTo("ms,tacho,metres");
        assertThat(Integer.parseInt(printed.get(1).substring("lines ".length()))).isBetween(10, 200);
        assertThat(Double.parseDouble(printed.get(2).substring("circumference ".length())))
                .as("of a wheel of 56 mm").isCloseTo(0.176, within(0.02));
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void behavioursAsInnerClassesPatrol(long seed) throws DescriptionException {
        Run run = run(Patrol.class, "pen", "educator", seed, "30s press ESCAPE 3s");
        assertThat(run.outcome().exitStatus()).as(run.outcome().toString()).contains(0);
        assertThat(run.robot().printedLines()).hasSize(3).startsWith("Arbitrator created").endsWith("end");
        assertThat(run.robot().printedLines().get(1)).startsWith("avoided true");
        assertThat(run.robot().distanceMetres()).isGreaterThan(1.5);
    }

    @Test
    void keysQueueWhatATimerTakes() throws DescriptionException {
        assertThat(printedBy(KeyDancer.class, "1300ms press LEFT 200ms", "1700ms press UP 200ms",
                "4s press RIGHT 200ms", "9s press ESCAPE 200ms"))
                .containsExactly("left", "jump", "right", "ticks true");
    }

    @Test
    void aGameDrawsItsPictures() throws DescriptionException {
        assertThat(printedBy(Pong.class)).containsExactly("still playing after 200");
        assertThat(folder.resolve("screen.png")).isNotEmptyFile();
    }

    @Test
    void everyModeOfEverySensorIsShown() throws DescriptionException {
        Run run = run(Dashboard.class, "pen", "educator", 1);
        assertThat(run.robot().printedLines()).containsExactly("EV3TouchSensor [Touch] 1",
                "EV3GyroSensor [Rate, Angle, Angle and Rate] 3", "EV3ColorSensor [ColorID, Red, RGB, Ambient] 4",
                "EV3UltrasonicSensor [Distance, Listen] 2", "[10, 29, 16]");
    }

    @Test
    void thereIsNobodyAtTheKeyboard() throws DescriptionException {
        assertThat(printedBy(KeyboardReader.class)).containsExactly("arguments 0", "commands 0");
    }
}
