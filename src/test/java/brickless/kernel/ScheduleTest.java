package brickless.kernel;

import static org.assertj.core.api.Assertions.assertThat;

import handwritten.LockOrder;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class ScheduleTest {
    private static final String BACKENDS = "brickless.kernel.Backends#available";
    private static final int ROUNDS = 5;
    private static final long PAUSE = 2_000;

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void roundRobinDoesNotFindTheLockOrderDeadlock(BackendChoice backend) {
        assertThat(lockOrder(Robot.settings(backend)).kind()).isEqualTo(ProgramEnd.Kind.EXITED);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void scheduleSeedsFindTheLockOrderDeadlockAndReplayIt(BackendChoice backend) {
        List<Integer> found = new ArrayList<>();
        for (int seed = 0; seed < 40; seed++) {
            ProgramEnd end = lockOrder(Robot.settings(backend).withScheduleSeed(seed));
            if (end.kind() == ProgramEnd.Kind.DEADLOCK) {
                found.add(seed);
                assertThat(lockOrder(Robot.settings(backend).withScheduleSeed(seed))).isEqualTo(end);
            }
        }
        assertThat(found).hasSizeBetween(5, 39);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void seedsDifferAndOneSeedIsAlwaysTheSame(BackendChoice backend) {
        List<List<String>> orders = new ArrayList<>();
        for (int seed = 0; seed < 10; seed++) {
            List<String> order = order(Robot.settings(backend).withScheduleSeed(seed));
            assertThat(order(Robot.settings(backend).withScheduleSeed(seed))).isEqualTo(order);
            orders.add(order);
        }
        assertThat(orders.stream().distinct().count()).isGreaterThan(5);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void everyThreadGetsTheProcessorInTurnByDefault(BackendChoice backend) {
        assertThat(order(Robot.settings(backend))).containsExactly("a", "b", "c", "d", "a", "b", "c", "d");
    }

    private static ProgramEnd lockOrder(KernelSettings settings) {
        Robot robot = new Robot(settings);
        return robot.run(() -> new LockOrder(robot.kernel).start(ROUNDS, PAUSE));
    }

    /** The order in which four busy threads reach the middle and the end of their work. */
    private static List<String> order(KernelSettings settings) {
        Robot robot = new Robot(settings);
        robot.run(() -> {
            for (String name : new String[] {"a", "b", "c", "d"}) {
                robot.start(name, () -> {
                    for (int i = 0; i < 2; i++) {
                        robot.work(9 * Robot.MILLI);
                        robot.log.add(name);
                    }
                });
            }
        });
        return robot.log;
    }
}
