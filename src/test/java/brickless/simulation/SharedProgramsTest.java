package brickless.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.bench.RobotGrid;
import brickless.kernel.BackendChoice;
import brickless.program.Program;
import brickless.simulation.ProgramLoaders.Sharing;
import brickless.trace.TraceListener;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Robots of a world that share the classes of their program leave the trace of robots that do not. */
class SharedProgramsTest {
    private static final int ROBOTS = 4;

    @ParameterizedTest
    @ValueSource(strings = {"Bumper", "LinePoller", "Courier", "Yielders"})
    void tracesAreThoseOfRobotsWithTheirOwnClasses(String program) {
        String name = "programs.speed." + program;
        SimulationSettings settings = settings(BackendChoice.AUTO);
        assertThat(trace(settings, name, true)).isEqualTo(trace(settings, name, false));
        SimulationSettings otherOrder = settings.toBuilder().scheduleSeed(OptionalLong.of(7)).build();
        assertThat(trace(otherOrder, name, true)).isEqualTo(trace(otherOrder, name, false));
    }

    @Test
    void tracesAreTheSameOnThreads() {
        String name = "programs.speed.Bumper";
        assertThat(trace(settings(BackendChoice.THREADS), name, true))
                .isEqualTo(trace(settings(BackendChoice.AUTO), name, false));
    }

    @Test
    void robotsWithTheSameProgramShareOneLoader() {
        try (ProgramLoaders loaders = new ProgramLoaders(Sharing.IN_THE_RUN)) {
            Program bumper = Program.onClassPath("programs.speed.Bumper");
            Program courier = Program.onClassPath("programs.speed.Courier");
            assertThat(loaders.contexts(List.of(bumper, courier, bumper)).stream().map(robot -> robot.loader())
                    .distinct()).hasSize(1);
        }
    }

    @Test
    void aProgramThatCouldNoticeIsNotShared() {
        try (ProgramLoaders loaders = new ProgramLoaders(Sharing.IN_THE_RUN)) {
            Program program = Program.onClassPath("programs.passing.initialisers.EnumConstants");
            assertThat(loaders.contexts(List.of(program, program)).stream().map(robot -> robot.loader())
                    .distinct()).hasSize(2);
        }
    }

    private static SimulationSettings settings(BackendChoice backend) {
        return SimulationSettings.builder(new RobotGrid(ROBOTS).world()).robot(RobotGrid.model())
                .limit(Duration.ofSeconds(10)).backend(backend).build();
    }

    private static String trace(SimulationSettings settings, String program, boolean sharing) {
        RunEngine engine = new RunEngine(settings, Program.onClassPath(program), Optional.empty(), TraceListener.NONE,
                new ProgramLoaders(sharing ? Sharing.IN_THE_RUN : Sharing.NONE));
        engine.advanceTo(Long.MAX_VALUE);
        return engine.report().traceHash();
    }
}
