package brickless.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import brickless.program.Program;
import brickless.program.ProgramException;
import brickless.program.ProgramFinder;
import brickless.simulation.ExamplePrograms.Trace;
import brickless.world.DescriptionException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * In each world of the library an example program does what the world is for, with several seeds of noise; where noise
 * alone changes little the start is moved by up to 8 mm and 2 degrees, too.
 */
class LibraryWorldsTest {
    @TempDir Path folder;
    private static final Map<String, Program> COMPILED = new TreeMap<>();

    @AfterAll
    static void removeClasses() {
        COMPILED.values().forEach(Program::close);
        COMPILED.clear();
    }

    /** A program, compiled from its folder alone: a robot is fitted to all classes that come with it. */
    private static Program program(String main) throws ProgramException {
        Program known = COMPILED.get(main);
        if (known == null) {
            Path folder = Path.of(System.getProperty("brickless.home"), "sim", "programs");
            known = new ProgramFinder(folder, List.of(), Optional.of(main)).find(main.substring(0, main.indexOf('.')));
            COMPILED.put(main, known);
        }
        return known;
    }

    private static SimulationSettings.Builder settings(String world, String robot, long seed)
            throws DescriptionException {
        Library library = new Library(Path.of(System.getProperty("brickless.home"), "no-files-here"));
        SimulationSettings.Builder settings = SimulationSettings.builder(library.world(world))
                .worldFile(world).seed(seed);
        return robot.equals("auto") ? settings : settings.robot(library.robot(robot));
    }

    /** The robot is put down a little beside its place. */
    private static List<Stimulus> nudge(String robot, double xMillimetres, double yMillimetres,
            double degrees, long seed)
            throws DescriptionException {
        Random random = new Random(seed);
        return StimuliReader.readText("start", String.format(Locale.ROOT, "0s move %s %.1f,%.1f %.2f", robot,
                xMillimetres + 16 * random.nextDouble() - 8, yMillimetres + 16 * random.nextDouble() - 8,
                degrees + 4 * random.nextDouble() - 2));
    }

    private Run run(String main, SimulationSettings.Builder settings, int seconds) throws ProgramException {
        Run run = new Simulation(settings.limit(Duration.ofSeconds(seconds)).out(Optional.of(folder)).build())
                .start(program(main));
        run.toEnd();
        return run;
    }

    private static void reachedGoal(Run run) {
        assertThat(run.outcome().kind()).as(run.outcome().toString()).isEqualTo("goal-reached");
        assertThat(run.report().exitStatus()).isZero();
    }

    private static void exited(Run run) {
        assertThat(run.outcome().exitStatus()).as(run.outcome().toString()).contains(0);
    }

    private static Optional<Goal> goal(String zone) {
        return Goal.parse("zone:" + zone);
    }

    private static long entered(Trace trace, String zone) {
        return trace.of("zone").stream().filter(line -> line.contains("\"zone\":\"" + zone + "\"")
                && line.contains("\"entered\":true")).count();
    }

    @Test
    void theLineFollowerCompletesTenLaps() throws Exception {
        Run run = run("linefollower.LineFollower", settings("line-loop", "educator", 1), 540);
        Trace trace = Trace.in(folder);
        assertThat(entered(trace, "lap")).as("the zone is entered at the beginning of each lap")
                .isGreaterThanOrEqualTo(11);
        assertThat(run.robot().distanceMetres() / (entered(trace, "lap") - 1)).as("metres a lap").isBetween(5.0, 5.3);
        double[] x = trace.numbers("sample", "x");
        double[] y = trace.numbers("sample", "y");
        assertThat(IntStream.range(0, x.length).allMatch(i -> x[i] > 0.2 && x[i] < 2.1 && y[i] > 0.1 && y[i] < 1.35))
                .as("near the line").isTrue();
    }

    @ParameterizedTest
    @ValueSource(longs = {2, 3, 4, 5})
    void theLineFollowerKeepsToTheLineWithAnySeed(long seed) throws Exception {
        run("linefollower.LineFollower", settings("line-loop", "auto", seed)
                .stimuli(nudge("robot", 660, 1250, 0, seed)), 115);
        assertThat(entered(Trace.in(folder), "lap")).isGreaterThanOrEqualTo(3);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void theLeftEdgeLeadsOverCrossingsAndGapsToTheRedMark(long seed) throws Exception {
        reachedGoal(run("crossings.LineMaster", settings("line-crossings", "auto", seed).goal(goal("goal")), 300));
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void theHandOnTheWallLeadsOutOfTheMaze(long seed) throws Exception {
        Run run = run("maze.MazeSolver", settings("maze", "auto", seed).goal(goal("goal"))
                .stimuli(nudge("robot", 190, 190, 90, seed)), 180);
        reachedGoal(run);
        assertThat(run.collisions()).as("touched walls").isLessThan(5);
        assertThat(run.robot().distanceMetres()).isBetween(11.0, 15.0);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void theCorridorIsDrivenInItsMiddle(long seed) throws Exception {
        Run run = run("corridor.CorridorCentering", settings("corridor", "auto", seed).goal(goal("goal")), 60);
        reachedGoal(run);
        assertThat(run.zonesEntered()).containsExactly("half-way", "goal");
        assertThat(run.collisions()).isZero();
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void theObstacleCourseIsCrossed(long seed) throws Exception {
        reachedGoal(run("obstacles.PlannedRoute", settings("obstacle-course", "auto", seed).goal(goal("goal")), 90));
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void allTilesAreNamed(long seed) throws Exception {
        Run run = run("colours.ColourReader", settings("colour-tiles", "auto", seed), 60);
        exited(run);
        assertThat(run.robot().printedLines()).containsExactly("black", "yellow", "red", "blue", "white", "green",
                "red", "black", "yellow", "white", "blue", "brown", "green", "white", "brown", "black", "red", "blue",
                "white", "blue", "brown", "green", "red", "yellow");
        assertThat(run.zonesEntered())
                .containsExactlyInAnyOrder("black", "yellow", "red", "blue", "white", "green", "brown");
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void theGuardStaysOnTheTableForTwoMinutes(long seed) throws Exception {
        Run run = run("tabletop.TableGuard", settings("table-top", "auto", seed)
                .stimuli(nudge("robot", 430, 500, 0, 10 * seed)), 130);
        exited(run);
        assertThat(run.time()).isGreaterThanOrEqualTo(Duration.ofSeconds(120));
        assertThat(run.robot().printedLines().get(0)).matches("edges: ([5-9]|\\d\\d)");
        assertThat(run.robot().distanceMetres()).isGreaterThan(10);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void whoDoesNotLookFallsOffTheTableAndIsTold(long seed) throws Exception {
        Run run = run("tabletop.Blindfold", settings("table-top", "auto", seed), 60);
        assertThat(run.outcome().kind()).isEqualTo("failed");
        assertThat(run.outcome().error().orElseThrow())
                .matches("fell: a wheel of robot is over the edge of the table after \\d+\\.?\\d* simulated seconds");
        assertThat(run.report().exitStatus()).isEqualTo(1);
        assertThat(Trace.in(folder).of("fell")).hasSize(1);
        assertThat(run.robot().xMetres() < 0.2 || run.robot().xMetres() > 1.8 || run.robot().yMetres() < 0.2
                || run.robot().yMetres() > 1.24).as("at the edge").isTrue();
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void theHeavierRobotPushesTheLighterOneOut(long seed) throws Exception {
        SimulationSettings.Builder settings = settings("sumo-ring", "auto", seed)
                .stimuli(seed == 1 ? List.of() : nudge("blue", 300, 0, 180, seed));
        Run run = run("sumo.Wrestler", settings, 60);
        assertThat(run.robots()).extracting(RobotView::name).containsExactly("red", "blue");
        assertThat(run.outcome().error().orElseThrow())
                .startsWith("fell: a wheel of blue is over the edge of the table");
        assertThat(run.collisions()).isPositive();
        RobotView red = run.robots().get(0);
        RobotView blue = run.robots().get(1);
        assertThat(Math.hypot(red.xMetres(), red.yMetres())).as("red is inside").isLessThan(0.6);
        assertThat(Math.hypot(blue.xMetres(), blue.yMetres())).as("blue is farther out").isGreaterThan(0.45);
        assertThat(Trace.in(folder).of("fell")).singleElement().asString().contains("\"robot\":\"blue\"");
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void theBeaconIsFoundBehindTheScreen(long seed) throws Exception {
        Run run = run("beacon.BeaconSeeker", settings("beacon-room", "auto", seed), 120);
        exited(run);
        assertThat(run.robot().printedLines()).containsExactly("home");
        assertThat(run.zonesEntered()).contains("goal").doesNotContain("second");
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void aCanIsCarriedHome(long seed) throws Exception {
        SimulationSettings.Builder settings = settings("can-field", "gripper", seed);
        Run run = run("carrier.CanCarrier", seed == 1 ? settings
                : settings.stimuli(nudge("robot", 1000, 1000, 0, seed)), 60);
        exited(run);
        assertThat(run.robot().printedLines()).containsExactly("got it", "brought it");
        assertThat(run.zonesEntered()).startsWith("ring").contains("goal");
        assertThat(cansAtHome(Trace.in(folder))).as("a can stands on the home patch").isPositive();
    }

    /** Cans of the last sample that stand on the patch from 60,1640 to 360,1940, where none was at the start. */
    private static long cansAtHome(Trace trace) {
        List<String> samples = trace.of("sample");
        double[][] starts = {{1205, 1205}, {795, 1205}, {795, 795}, {1205, 795}, {1510, 1101}, {1289, 1432},
                {899, 1510}, {568, 1289}, {490, 899},
            {711, 568}, {1101, 490}, {1432, 711}};
        Matcher moved = Pattern.compile(
                "\"id\":\"can-(\\d+)\",\"x\":(-?[\\d.]+),\"y\":(-?[\\d.]+),\"heading\":(-?[\\d.]+)")
                .matcher(samples.get(samples.size() - 1));
        long home = 0;
        while (moved.find()) {
            double[] start = starts[Integer.parseInt(moved.group(1)) - 1];
            double angle = Math.toRadians(Double.parseDouble(moved.group(4)));
            double x = 1000 * Double.parseDouble(moved.group(2))
                    + start[0] * Math.cos(angle) - start[1] * Math.sin(angle);
            double y = 1000 * Double.parseDouble(moved.group(3)) + start[0] * Math.sin(angle)
                    + start[1] * Math.cos(angle);
            home += x > 60 && x < 360 && y > 1640 && y < 1940 ? 1 : 0;
        }
        return home;
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void theBrightLampIsFound(long seed) throws Exception {
        Run run = run("light.LightSeeker", settings("lamp-room", "auto", seed), 300);
        exited(run);
        assertThat(run.robot().printedLines()).last().isEqualTo("bright");
        assertThat(Math.hypot(run.robot().xMetres() - 1.56, run.robot().yMetres() - 0.46)).as("near the strong lamp")
                .isLessThan(0.35);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void theTurretMeasuresTheRoomAllRound(long seed) throws Exception {
        Run run = run("scanner.TurretScanner", settings("pen", "medium-turret", seed), 30);
        exited(run);
        List<String> lines = run.robot().printedLines();
        assertThat(lines).hasSize(13);
        assertThat(lines.stream().limit(12).map(line -> Integer.parseInt(line.split(" ")[0])))
                .containsExactly(-180, -150, -120, -90, -60, -30, 0, 30, 60, 90, 120, 150);
        assertThat(Arrays.asList(lines.get(0).split(" ")).get(1)).as("ahead, to the far wall").matches("1[45]\\d\\d");
        assertThat(lines.get(12)).isEqualTo("best -180");
        assertThat(run.robot().headingDegrees()).isCloseTo(0, within(3.0));
    }
}
