package brickless.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import brickless.program.ProgramException;
import brickless.world.DescriptionException;
import brickless.world.RobotModel;
import brickless.world.svg.SvgWorldReader;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Programs that drive by pilots, navigators and localisation, on the whole simulated robot. */
class PilotProgramsTest {
    private static final String OPEN_FLOOR = "<g data-robot='robot' transform='translate(1000 1500)'/>";
    private static final String WALL_AHEAD =
            "<rect data-solid='fixed' data-height-mm='200' x='2000' y='0' width='100' height='3000'/>" + OPEN_FLOOR;
    /** Distance of the educator's ultrasonic sensor and of its bumper from its axle, metres. */
    private static final double EAR_METRES = 0.078;
    private static final double BUMPER_METRES = 0.110;

    private static ExamplePrograms programs;

    @BeforeAll
    static void compile() throws ProgramException {
        programs = ExamplePrograms.compiled();
    }

    @AfterAll
    static void removeClasses() {
        programs.close();
    }

    private static Run run(String main, String world, boolean ideal, long seed) throws DescriptionException {
        RobotModel educator = new Library(Path.of("no-files-here")).robot("educator");
        String drawing = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 4000 3000'>" + world + "</svg>";
        SimulationSettings settings = SimulationSettings.builder(SvgWorldReader.readText("test.svg", drawing))
                .robot(educator).ideal(ideal).seed(seed).limit(Duration.ofSeconds(120)).build();
        Run run = new Simulation(settings).start(programs.program(main));
        run.toEnd();
        assertThat(run.outcome().exitStatus()).as(run.outcome().toString()).contains(0);
        return run;
    }

    @ParameterizedTest
    @CsvSource({"true, 1", "false, 1", "false, 2", "false, 3"})
    void squareOfFourMetresCloses(boolean ideal, long seed) throws DescriptionException {
        Run run = run("pilotsquare.PilotSquare", OPEN_FLOOR, ideal, seed);
        assertThat(run.robot().distanceMetres()).isCloseTo(4, within(0.05));
        assertThat(run.robot().xMetres()).isCloseTo(1, within(0.04));
        assertThat(run.robot().yMetres()).isCloseTo(1.5, within(0.04));
        assertThat(run.robot().headingDegrees()).as("four left turns, each a little short")
                .isCloseTo(-360, within(ideal ? 2.0 : 5.0));
        assertThat(run.robot().printedLines()).hasSize(4).last().asString().startsWith("4: X:");
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void navigatorReachesFiveWaypointsInOrder(long seed) throws DescriptionException {
        Run run = run("waypoints.Waypoints", OPEN_FLOOR, false, seed);
        assertThat(run.robot().printedLines()).hasSize(7).endsWith("complete 5", "done true");
        assertThat(run.robot().printedLines().stream().limit(5)).satisfiesExactly(
                line -> assertThat(line).startsWith("reached 1 at X:50 "), line -> assertThat(line)
                .startsWith("reached 2 at X:50 Y:40 "), line -> assertThat(line).as("within a centimetre")
                .matches("reached 3 at X:100 Y:(39|40) .*"),
                line -> assertThat(line).matches("reached 4 at X:80 Y:-(29|30) .*"),
                line -> assertThat(line).matches("reached 5 at X:-?[01] Y:-?[01] H:-?1(80|79)"));
        assertThat(run.robot().xMetres()).isCloseTo(1, within(0.05));
        assertThat(run.robot().yMetres()).isCloseTo(1.5, within(0.05));
    }

    @Test
    void odometryIsTheTruthOnAnIdealFloor() throws DescriptionException {
        Run run = run("thereandback.ThereAndBack", OPEN_FLOOR, true, 1);
        double x = (run.robot().xMetres() - 1) * 1000;
        double y = -(run.robot().yMetres() - 1.5) * 1000;
        double onePercent = run.robot().distanceMetres() * 10;
        String[] last = run.robot().printedLines().get(6).split(" \\| ");
        for (String pose : List.of(last[1], last[2])) {
            double[] said = Stream.of(pose.split(" ")).mapToDouble(Double::parseDouble).toArray();
            assertThat(said[0]).as("x of " + pose).isCloseTo(x, within(onePercent));
            assertThat(said[1]).as("y of " + pose).isCloseTo(y, within(onePercent));
            assertThat(said[2]).as("heading of " + pose).isCloseTo(-run.robot().headingDegrees(), within(1.0));
        }
    }

    @Test
    void odometryKnowsBackwardFromForward() throws DescriptionException {
        Run run = run("thereandback.ThereAndBack", OPEN_FLOOR, true, 1);
        assertThat(run.robot().printedLines().get(0)).startsWith("forward | 600.");
        assertThat(run.robot().printedLines().get(1)).matches("backward \\| (199|200)\\..* \\| (199|200)\\..*");
    }

    /** An L-shaped room of 1.5 m by 1.1 m; the map's origin is its lower left corner. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void localisationFindsTheRobotInItsRoom(long seed) throws DescriptionException {
        Run run = run("localize.Localize", "<g data-solid='fixed' data-height-mm='200' data-friction='0.3'>"
                + "<rect x='-30' y='-30' width='960' height='30'/><rect x='-30' y='0' width='30' height='1130'/>"
                + "<rect x='0' y='1100' width='1530' height='30'/><rect x='1500' y='500' width='30' height='600'/>"
                + "<rect x='900' y='-30' width='630' height='530'/></g>"
                + "<g data-robot='robot' transform='translate(550 650) rotate(-70)'/>", false, seed);
        double[] said = Stream.of(run.robot().printedLines().get(11).split(" "))
                .mapToDouble(Double::parseDouble).toArray();
        assertThat(said[0] / 100).isCloseTo(run.robot().xMetres(), within(0.10));
        assertThat(said[1] / 100).isCloseTo(1.1 - run.robot().yMetres(), within(0.10));
        assertThat(Math.IEEEremainder(said[2] + run.robot().headingDegrees(), 360)).as("heading")
                .isCloseTo(0, within(20.0));
        double[] first = Stream.of(run.robot().printedLines().get(0).split(" "))
                .mapToDouble(Double::parseDouble).toArray();
        assertThat(said[3]).as("the guesses come together").isLessThan(first[3] / 2);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void routeAroundMappedWallsIsDrivenWithoutAContact(long seed) throws DescriptionException {
        Run run = run("roomroute.RoomRoute",
                "<g data-solid='fixed' data-height-mm='200' fill='none' stroke='#64788c' stroke-width='20'>"
                + "<rect x='700' y='800' width='2200' height='1300'/><path d='M1400,2100 V1300'/>"
                + "<path d='M1900,1600 V800'/><path d='M2400,2100 V1350'/></g>" + OPEN_FLOOR, false, seed);
        assertThat(run.robot().printedLines())
                .containsExactly("ShortestPathFinder", "0 0", "40 38", "90 -28", "140 33", "170 -20", "done true");
        assertThat(run.collisions()).isZero();
        assertThat(run.robot().xMetres()).isCloseTo(2.7, within(0.05));
        assertThat(run.robot().yMetres()).isCloseTo(1.7, within(0.05));
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void rangeDetectorStopsTheRobotInTime(long seed) throws DescriptionException {
        Run run = run("detectors.RangeStop", WALL_AHEAD, false, seed);
        assertThat(run.robot().printedLines()).singleElement().asString().startsWith("seen at 0.3");
        assertThat(run.collisions()).isZero();
        assertThat(2.0 - run.robot().xMetres() - EAR_METRES).as("distance of the sensor from the wall")
                .isBetween(0.32, 0.40);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void touchDetectorStopsTheRobotAndItBacksOff(long seed) throws DescriptionException {
        Run run = run("detectors.TouchStop", WALL_AHEAD, false, seed);
        assertThat(run.robot().printedLines()).containsExactly("touched", "backed off");
        assertThat(2.0 - run.robot().xMetres() - BUMPER_METRES).isCloseTo(0.20, within(0.03));
        assertThat(run.time()).as("it does not push on").isLessThan(Duration.ofSeconds(12));
    }
}
