package brickless.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import brickless.program.Program;
import brickless.program.ProgramException;
import brickless.program.ProgramFinder;
import brickless.world.DescriptionException;
import brickless.world.svg.SvgRobotReader;
import brickless.world.svg.SvgWorldReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

/**
 * The programs in {@code programs.fitted}, written as people write them, drive without a robot file as their authors
 * meant. Each is compiled from its sources, as the command line does. A pilot whose left wheel has the negative offset
 * turns to the right for positive angles, as on the brick.
 */
class FittedRobotsTest {
    private static final Path PROGRAMS = Path.of(System.getProperty("brickless.home"), "src", "test", "java",
            "programs", "fitted");
    private static final double START_X = 1.5;
    private static final double START_Y = 1.5;
    private static final String WORLD = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 3000 3000'>"
            + "<rect width='3000' height='3000' fill='white'/>"
            + "<rect data-solid='fixed' data-height-mm='200' width='3000' height='3000' fill='none' stroke='black' "
            + "stroke-width='40'/><g data-robot='robot' transform='translate(1500 1500)'/></svg>";

    /**
     * What the author of a program meant.
     *
     * @param folder folder and package of the program
     * @param robot texts that the description of the fitted robot holds
     * @param metres length of the way
     * @param ahead metres from the start to the end, ahead
     * @param left and to the left, as the robot stood at the start
     * @param degrees heading at the end, counter-clockwise
     * @param printed last line printed, empty if none
     */
    private record Meant(String folder, List<String> robot, double metres, double ahead, double left, double degrees,
            String printed) {}

    private static final double FIVE_TURNS = 5 * Math.PI * 0.056;

    private static final List<Meant> PROGRAMS_MEANT = List.of(
            new Meant("statics", List.of("left wheel on A (large motor, 56.0 mm)", "right wheel on D", "track 120 mm"),
                    2 * FIVE_TURNS, FIVE_TURNS, FIVE_TURNS, -90, "Press a button"),
            new Meant("constants", List.of("left wheel on A (large motor, 43.0 mm)",
                    "right wheel on D (large motor, 43.0 mm)", "track 156 mm"),
                    3 * 0.6096, 0, -0.6096, -270, ""),
            new Meant("diffpilot", List.of("left wheel on C (large motor, 57.2 mm)",
                    "right wheel on B (large motor, 57.2 mm)", "track 140 mm"),
                    0.762, 0.508, 0.254, 90, ""),
            new Meant("movepilot", List.of("left wheel on D (large motor, 43.2 mm)", "right wheel on A", "track 160 mm",
                    "ev3-ultrasonic on S2"), 0.5 + 0.47124, 0.8, 0.3, 0, "0.5"),
            new Meant("millimetres",
                    List.of("left wheel on B (large motor reversed, 81.6 mm, gear 3.00)", "track 140 mm"),
                    0.7, 0.4, -0.3, -90, ""),
            new Meant("holonomic", List.of("omni wheel on A (medium motor, 48.0 mm)", "omni wheel on B",
                    "omni wheel on C"), 0.4, 0.4, 0, 120, ""),
            new Meant("mediums", List.of("left wheel on A (medium motor, 68.8 mm)",
                    "right wheel on B (medium motor, 68.8 mm)"),
                    0.8, 0.4, 0, 0, "0"),
            new Meant("collections",
                    List.of("left wheel on C (large motor, 62.4 mm)", "right wheel on B", "track 128 mm"),
                    0.9, 0, 0, -180, ""),
            new Meant("factories", List.of("left wheel on D (large motor, 43.2 mm)", "right wheel on B", "track 135 mm",
                    "ev3-touch on S1"), 0.6, 0.3, 0.3, -90, "0.0"),
            new Meant("subclasses", List.of("left wheel on B (large motor, 43.2 mm)", "right wheel on A",
                    "track 138 mm", "ev3-color on S4"), 0.6, 0.4, -0.2, -90, "white"),
            new Meant("properties", List.of("left wheel on B (large motor, 49.6 mm)", "right wheel on A",
                    "track 130 mm"), 0.8, 0.4, -0.4, -180, ""),
            new Meant("sensors", List.of("left wheel on B", "right wheel on A", "nxt-ultrasonic on S1",
                    "nxt-light on S2", "ev3-gyro on S3", "nxt-touch on S4"), 1.1, 0, 1.1, 90, "bright"),
            new Meant("owndrivers", List.of("left wheel on B", "right wheel on C", "nxt-ultrasonic on S1",
                    "nxt-touch on S2", "ev3-ultrasonic on S4"), 1.1, 1.1, 0, 0, "agreed"));

    @TempDir Path folder;

    @TestFactory
    Stream<DynamicTest> programsDriveAsTheirAuthorsMeant() {
        return PROGRAMS_MEANT.stream().map(meant -> DynamicTest.dynamicTest(meant.folder, () -> {
            try (Program program = find(meant.folder)) {
                drivesAsMeant(meant, run(program, Optional.empty(), meant.folder));
            }
        }));
    }

    @Test
    void everyProgramIsTried() throws IOException {
        try (Stream<Path> folders = Files.list(PROGRAMS)) {
            assertThat(folders.map(each -> each.getFileName().toString())).containsExactlyInAnyOrderElementsOf(
                    PROGRAMS_MEANT.stream().map(Meant::folder).toList());
        }
    }

    private static Program find(String name) throws ProgramException {
        return new ProgramFinder(PROGRAMS, List.of(), Optional.empty()).find(name);
    }

    private Run run(Program program, Optional<Path> robot, String out) throws DescriptionException {
        SimulationSettings.Builder settings = SimulationSettings.builder(SvgWorldReader.readText("open.svg", WORLD))
                .limit(Duration.ofSeconds(60)).out(Optional.of(folder.resolve(out)));
        if (robot.isPresent()) {
            settings.robot(SvgRobotReader.read(robot.get()));
        }
        Run run = new Simulation(settings.build()).start(program);
        run.toEnd();
        return run;
    }

    private static void drivesAsMeant(Meant meant, Run run) {
        assertThat(run.outcome().exitStatus()).as(run.outcome().toString()).contains(0);
        assertThat(run.report().notes().get(0)).contains(meant.robot);
        RobotView robot = run.robot();
        double tolerance = 0.03 * meant.metres;
        assertThat(robot.distanceMetres()).as("length of the way").isCloseTo(meant.metres, within(2 * tolerance));
        assertThat(robot.xMetres() - START_X).as("ahead").isCloseTo(meant.ahead, within(tolerance));
        assertThat(START_Y - robot.yMetres()).as("to the left").isCloseTo(meant.left, within(tolerance));
        assertThat(-robot.headingDegrees()).as("heading").isCloseTo(meant.degrees, within(4.0));
        assertThat(run.collisions()).isZero();
        if (!meant.printed.isEmpty()) {
            assertThat(robot.printedLines()).last().asString().startsWith(meant.printed);
        }
    }

    /** The drawing in the folder of a run can be given to the next one, which is then the same. */
    @TestFactory
    Stream<DynamicTest> drawingOfTheFittedRobotRepeatsTheRun() {
        return PROGRAMS_MEANT.stream().map(Meant::folder).map(name -> DynamicTest.dynamicTest(name, () -> {
            try (Program program = find(name)) {
                Run fitted = run(program, Optional.empty(), name);
                Run drawn = run(program, Optional.of(folder.resolve(name).resolve("robot.svg")), name + "-again");
                assertThat(drawn.report().traceHash()).isEqualTo(fitted.report().traceHash());
                assertThat(fitted.report().robot()).isEqualTo("auto");
                assertThat(drawn.report().robot()).isEqualTo("robot");
            }
        }));
    }
}
