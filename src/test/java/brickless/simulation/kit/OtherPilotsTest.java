package brickless.simulation.kit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.offset;

import brickless.simulation.Library;
import brickless.simulation.Run;
import brickless.simulation.Simulation;
import brickless.simulation.SimulationSettings;
import brickless.world.DescriptionException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.function.UnaryOperator;
import kit.CarDrive;
import kit.CompassSquare;
import kit.HolonomicDrive;
import kit.OmniDrive;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Pilots of robots that are not driven by two wheels side by side, on the simulated robot. */
class OtherPilotsTest {
    private static final String FLOOR = Kit.world("<g data-robot='robot' transform='translate(1000 1000)'/>");

    private static Run run(Class<?> program, String robot, long seed, boolean ideal) throws DescriptionException {
        SimulationSettings settings = SimulationSettings.builder(Kit.worldOf(FLOOR))
                .robot(new Library(Path.of("no-files-here")).robot(robot))
                .seed(seed).ideal(ideal).limit(Duration.ofSeconds(60)).pressButtons(false).build();
        Run run = new Simulation(settings).start(program);
        run.toEnd();
        assertThat(run.outcome().exitStatus()).as(run.outcome().toString()).contains(0);
        return run;
    }

    @ParameterizedTest
    @CsvSource({"1, true", "1, false", "2, false", "3, false"})
    void theOmniPilotDrivesAheadSidewaysAndTurns(long seed, boolean ideal) throws DescriptionException {
        Run run = run(OmniDrive.class, "three-wheel-holonomic", seed, ideal);
        assertThat(run.robot().xMetres()).isCloseTo(1.3, offset(0.03));
        assertThat(run.robot().yMetres()).isCloseTo(0.8, offset(0.03));
        assertThat(run.robot().headingDegrees()).isCloseTo(-90, offset(5.0));
        assertThat(run.robot().printedLines()).containsExactly("moving false");
    }

    @ParameterizedTest
    @CsvSource({"1, true", "1, false", "2, false", "3, false"})
    void theHolonomicChassisDrivesInAllDirectionsAndKnowsWhereItIs(long seed, boolean ideal)
            throws DescriptionException {
        Run run = run(HolonomicDrive.class, "three-wheel-holonomic", seed, ideal);
        assertThat(run.robot().xMetres()).as("to the left of where it looks").isCloseTo(0.8, offset(0.04));
        assertThat(run.robot().yMetres()).isCloseTo(0.7, offset(0.04));
        Printed printed = Kit.printed(run);
        double tolerance = ideal ? 0.5 : 4;
        assertThat(printed.number("pose", 0)).isCloseTo((run.robot().xMetres() - 1) * 100, offset(tolerance));
        assertThat(printed.number("pose", 1)).isCloseTo((1 - run.robot().yMetres()) * 100, offset(tolerance));
        assertThat(printed.number("pose", 2)).isCloseTo(-run.robot().headingDegrees(), offset(ideal ? 1.0 : 5.0));
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void theCompassPilotKeepsItsDirections(long seed) throws DescriptionException {
        Run run = run(CompassSquare.class, "educator", seed, false);
        assertThat(run.robot().xMetres()).isCloseTo(1, offset(0.06));
        assertThat(run.robot().yMetres()).isCloseTo(1, offset(0.06));
        assertThat(Math.IEEEremainder(run.robot().headingDegrees(), 360)).isCloseTo(0, offset(10.0));
    }

    @Test
    void theSteeringPilotFindsItsEndsSteersAndDrives() {
        try (Run run = Kit.run(CarDrive.class, Kit.EMPTY, Kit.BENCH, UnaryOperator.identity())) {
            Printed printed = Kit.printed(run);
            assertThat(printed.number("straight")).as("in the middle of 90 degrees").isCloseTo(0, offset(2.0));
            assertThat(printed.number("left")).isCloseTo(-45, offset(4.0));
            assertThat(printed.number("left", 1)).as("39.3 cm").isCloseTo(803, offset(2.0));
            assertThat(printed.number("right")).isCloseTo(45, offset(4.0));
            assertThat(printed.number("right", 1)).as("10 cm back").isCloseTo(803 - 204, offset(3.0));
            assertThat(printed.number("ahead")).isCloseTo(0, offset(2.0));
            assertThat(printed.number("ahead", 1)).isCloseTo(803, offset(4.0));
            assertThat(printed.number("driven.TRAVEL")).isCloseTo(10, offset(0.1));
            assertThat(printed.number("moving")).isEqualTo(1);
            assertThat(printed.number("stopped")).isZero();
            assertThat(run.robot().printedLines().stream().filter("started"::equals)).hasSize(4);
        }
    }
}
