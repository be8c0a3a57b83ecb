package brickless.kernel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class EnsembleTest {
    private static final String BACKENDS = "brickless.kernel.Backends#available";
    private static final long LIMIT = 200 * Robot.MILLI;

    private final List<Long> steps = new ArrayList<>();

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void threeKernelsDoTogetherWhatEachDoesAlone(BackendChoice backend) {
        List<ScheduleHash> together = new ArrayList<>();
        List<Kernel> kernels = new ArrayList<>();
        for (int i = 0; i < 3; i++) {
            Robot robot = program(backend, i, null);
            together.add(ScheduleHash.of(robot.kernel));
            kernels.add(robot.kernel);
        }
        List<ProgramEnd> ends = new Ensemble(kernels, steps::add).run();
        for (int i = 0; i < 3; i++) {
            Robot robot = program(backend, i, time -> { });
            ScheduleHash alone = ScheduleHash.of(robot.kernel);
            ProgramEnd end = new Ensemble(List.of(robot.kernel), time -> { }).run().get(0);
            assertThat(ends.get(i)).isEqualTo(end);
            assertThat(together.get(i)).isEqualTo(alone);
        }
        assertThat(together).allSatisfy(hash -> assertThat(hash.events()).isGreaterThan(20));
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void eachBoundaryIsSteppedOnceWhenAllHaveReachedIt(BackendChoice backend) {
        List<Kernel> kernels = new ArrayList<>();
        List<String> late = new ArrayList<>();
        for (int i = 0; i < 3; i++) {
            kernels.add(program(backend, i, null).kernel);
        }
        new Ensemble(kernels, time -> {
            steps.add(time);
            for (Kernel kernel : kernels) {
                if (kernel.end() == null && kernel.nowNanos() != time) {
                    late.add(kernel.nowNanos() + " at " + time);
                }
            }
        }).run();
        assertThat(late).isEmpty();
        assertThat(steps).hasSize(100).doesNotHaveDuplicates().isSorted();
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void sharesRunInTheOrderOfTheList(BackendChoice backend) {
        List<String> order = new ArrayList<>();
        List<Kernel> kernels = new ArrayList<>();
        for (String name : new String[] {"a", "b", "c"}) {
            Robot robot = new Robot(Robot.settings(backend));
            robot.kernel.main(Robot.thread("main", () -> { }), Robot.runnable(() -> {
                for (int i = 0; i < 3; i++) {
                    order.add(name);
                    robot.sleepMillis(2);
                }
            }));
            kernels.add(robot.kernel);
        }
        new Ensemble(kernels, time -> order.add("|")).run();
        assertThat(order).containsExactly("a", "b", "c", "|", "a", "b", "c", "|", "a", "b", "c", "|");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aProgramThatEndsDropsOut(BackendChoice backend) {
        int[] lifeMillis = {5, 11, 3};
        List<Kernel> kernels = new ArrayList<>();
        for (int millis : lifeMillis) {
            Robot robot = new Robot(Robot.settings(backend));
            robot.kernel.main(Robot.thread("main", () -> { }), Robot.runnable(() -> robot.sleepMillis(millis)));
            kernels.add(robot.kernel);
        }
        List<ProgramEnd> ends = new Ensemble(kernels, steps::add).run();
        assertThat(ends).extracting(end -> end.timeNanos() / Robot.MILLI).containsExactly(5L, 11L, 3L);
        assertThat(steps).containsExactly(2_000_000L, 4_000_000L, 6_000_000L, 8_000_000L, 10_000_000L);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void theStepHandlerCanEndOneProgramAndTheOthersGoOn(BackendChoice backend) {
        Robot first = new Robot(Robot.settings(backend).withLimitNanos(LIMIT));
        Robot second = new Robot(Robot.settings(backend).withLimitNanos(LIMIT));
        first.kernel.main(Robot.thread("main", () -> { }), first::spin);
        second.kernel.main(Robot.thread("main", () -> { }), second::spin);
        List<ProgramEnd> ends = new Ensemble(List.of(first.kernel, second.kernel), time -> {
            if (time == 10 * Robot.MILLI) {
                second.kernel.goalReached();
            }
        }).run();
        assertThat(ends).extracting(ProgramEnd::kind)
                .containsExactly(ProgramEnd.Kind.TIME_LIMIT, ProgramEnd.Kind.GOAL_REACHED);
        assertThat(ends).extracting(ProgramEnd::timeNanos).containsExactly(LIMIT, 10 * Robot.MILLI);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void robotsTalkThroughSignalsRaisedAtBoundaries(BackendChoice backend) {
        Robot sender = new Robot(Robot.settings(backend).withLimitNanos(LIMIT));
        Robot receiver = new Robot(Robot.settings(backend).withLimitNanos(LIMIT));
        boolean[] sent = new boolean[1];
        Processor.Signal arrival = receiver.kernel.newSignal();
        sender.kernel.main(Robot.thread("main", () -> { }), Robot.runnable(() -> {
            sender.sleepMillis(5);
            sent[0] = true;
        }));
        receiver.kernel.main(Robot.thread("main", () -> { }), Robot.runnable(() -> {
            arrival.await(0);
            receiver.note("received");
        }));
        new Ensemble(List.of(sender.kernel, receiver.kernel), time -> {
            if (sent[0]) {
                arrival.raise();
            }
        }).run();
        assertThat(receiver.log).containsExactly("6 received");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void whatTheStepThrowsEndsAllPrograms(BackendChoice backend) {
        IllegalStateException bug = new IllegalStateException("bug");
        List<Kernel> kernels = List.of(program(backend, 0, null).kernel, program(backend, 1, null).kernel);
        assertThatThrownBy(() -> new Ensemble(kernels, time -> {
            throw bug;
        }).run()).isSameAs(bug);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void differentStepLengthsAreRefused(BackendChoice backend) {
        List<Kernel> kernels = List.of(new Robot(Robot.settings(backend)).kernel,
                new Robot(Robot.settings(backend).withStepNanos(7)).kernel);
        assertThatThrownBy(() -> new Ensemble(kernels, time -> { })).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new Ensemble(List.of(), time -> { })).isInstanceOf(IllegalArgumentException.class);
    }

    /** A program with two threads and a lock whose timing depends on its number; number 2 ends early. */
    private static Robot program(BackendChoice backend, int number, StepHandler handler) {
        Robot robot = new Robot(Robot.settings(backend).withSeed(number).withLimitNanos(LIMIT), handler);
        int rounds = number == 2 ? 5 : 1_000;
        robot.kernel.main(Robot.thread("main", () -> { }),
                Robot.runnable(() -> BusyProgram.run(robot, 3 + number, rounds)));
        return robot;
    }
}
