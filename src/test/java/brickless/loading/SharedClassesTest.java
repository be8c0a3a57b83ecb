package brickless.loading;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.kernel.BackendChoice;
import brickless.kernel.KernelSettings;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

/** Robots that share the classes of a program behave as if each had its own. */
class SharedClassesTest {
    private static final int ROBOTS = 3;
    private static final long NANOS_PER_SECOND = 1_000_000_000L;

    /** Of these the watchdog of the host would have to end each robot, one after the other. */
    private static boolean endsOnTheHost(FixtureProgram program) {
        return program.expected().equals("runaway") || program.outside();
    }

    @TestFactory
    Stream<DynamicTest> everyProgramDoesTheSameWithSharedClasses() throws IOException {
        return FixtureProgram.all().stream().filter(program -> !endsOnTheHost(program) && isShareable(program))
                .map(program -> DynamicTest.dynamicTest(program.mainClass(),
                        () -> checkWith(program, BackendChoice.AUTO, true)));
    }

    @TestFactory
    Stream<DynamicTest> onThreadsAndInOrderToo() throws IOException {
        return FixtureProgram.all().stream()
                .filter(program -> program.mainClass().contains(".statics.")
                        || program.mainClass().contains(".initialisers."))
                .filter(SharedClassesTest::isShareable)
                .map(program -> DynamicTest.dynamicTest(program.mainClass(), () -> {
                    checkWith(program, BackendChoice.THREADS, true);
                    checkWith(program, BackendChoice.AUTO, false);
                }));
    }

    private static boolean isShareable(FixtureProgram program) {
        return SharingObstacles.firstIn(RobotClassLoader.ofApplication(), List.of(program.mainClass())).isEmpty();
    }

    private static void checkWith(FixtureProgram program, BackendChoice backend, boolean randomSchedules) {
        List<ProgramRun> own = runs(program, backend, randomSchedules, false);
        List<ProgramRun> shared = runs(program, backend, randomSchedules, true);
        for (int i = 0; i < ROBOTS; i++) {
            assertThat(shared.get(i).output()).as("robot %d", i).isEqualTo(own.get(i).output());
            assertThat(shared.get(i).end().kind()).as("robot %d", i).isEqualTo(own.get(i).end().kind());
            assertThat(shared.get(i).end().dump()).as("robot %d", i).isEqualTo(own.get(i).end().dump());
            assertThat(shared.get(i).traceHash()).as("robot %d", i).isEqualTo(own.get(i).traceHash());
        }
    }

    private static List<ProgramRun> runs(FixtureProgram program, BackendChoice backend, boolean randomSchedules,
            boolean shared) {
        List<RobotContext> robots = new ArrayList<>();
        List<KernelSettings> settings = new ArrayList<>();
        RobotClassLoader together = RobotClassLoader.ofApplication().forSeveralRobots();
        for (int i = 0; i < ROBOTS; i++) {
            robots.add((shared ? together : RobotClassLoader.ofApplication()).newRobot());
            KernelSettings plain = KernelSettings.defaults().withStepNanos(10_000_000)
                    .withLimitNanos(program.limitSeconds() * NANOS_PER_SECOND).withBackend(backend).withSeed(i);
            settings.add(randomSchedules ? plain.withScheduleSeed(i) : plain);
        }
        return ProgramRun.together(robots, program.mainClass(), settings, program.input());
    }
}
