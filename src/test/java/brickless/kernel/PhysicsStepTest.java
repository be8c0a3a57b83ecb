package brickless.kernel;

import static brickless.kernel.Robot.MILLI;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.LongStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class PhysicsStepTest {
    private static final String BACKENDS = "brickless.kernel.Backends#available";

    private final List<Long> steps = new ArrayList<>();

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void everyMultipleOfTheStepIsSteppedWhileAThreadSleeps(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend), steps::add);
        ProgramEnd end = robot.run(() -> robot.sleepMillis(11));
        assertThat(steps).containsExactly(2 * MILLI, 4 * MILLI, 6 * MILLI, 8 * MILLI, 10 * MILLI);
        assertThat(end.timeNanos()).isEqualTo(11 * MILLI);
        assertThat(robot.kernel.physicsSteps()).isEqualTo(5);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void theClockStandsAtTheBoundaryDuringAStep(BackendChoice backend) {
        Robot[] robot = new Robot[1];
        List<Long> clock = new ArrayList<>();
        robot[0] = new Robot(Robot.settings(backend).withStepNanos(MILLI), time -> {
            steps.add(time);
            clock.add(robot[0].kernel.nowNanos());
        });
        robot[0].run(() -> {
            robot[0].work(7 * MILLI + 300);
            robot[0].kernel.charge(5 * MILLI + 77);
            robot[0].sleepMillis(3);
        });
        assertThat(steps).hasSize(15).isEqualTo(LongStream.rangeClosed(1, 15).mapToObj(i -> i * MILLI).toList());
        assertThat(clock).isEqualTo(steps);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void oneLongChargeRunsAllStepsOnItsWay(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend), steps::add);
        robot.run(() -> {
            robot.kernel.charge(9 * MILLI);
            robot.note("charged, steps " + steps.size());
        });
        assertThat(robot.log).containsExactly("9 charged, steps 4");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aCallThatEndsExactlyAtABoundarySeesTheStep(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend), steps::add);
        robot.run(() -> {
            robot.kernel.charge(2 * MILLI);
            robot.note("steps " + steps.size());
        });
        assertThat(robot.log).containsExactly("2 steps 1");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aStepComesBeforeAnEventOfTheSameTimeAndBothBeforeTheProgram(BackendChoice backend) {
        Robot[] robot = new Robot[1];
        robot[0] = new Robot(Robot.settings(backend), time -> robot[0].note("step"));
        robot[0].run(() -> {
            robot[0].kernel.at(2 * MILLI, () -> robot[0].note("event"));
            robot[0].kernel.at(MILLI, () -> robot[0].note("event"));
            robot[0].sleepMillis(2);
            robot[0].note("program");
        });
        assertThat(robot[0].log).containsExactly("1 event", "2 step", "2 event", "2 program");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aStepCanEndTheRunAtItsOwnTime(BackendChoice backend) {
        Robot[] robot = new Robot[1];
        robot[0] = new Robot(Robot.settings(backend), time -> {
            if (time == 6 * MILLI) {
                robot[0].kernel.goalReached();
            }
        });
        ProgramEnd end = robot[0].run(() -> robot[0].spin());
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.GOAL_REACHED);
        assertThat(end.timeNanos()).isEqualTo(6 * MILLI);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void whatAStepThrowsComesOutOfTheRunAndNotIntoTheProgram(BackendChoice backend) {
        IllegalArgumentException bug = new IllegalArgumentException("bug");
        Robot robot = new Robot(Robot.settings(backend), time -> {
            throw bug;
        });
        assertThatThrownBy(() -> robot.run(() -> {
            try {
                robot.spin();
            } catch (IllegalArgumentException e) {
                robot.note("seen by the program");
            }
        })).isSameAs(bug);
        assertThat(robot.log).isEmpty();
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aStepMustNotCharge(BackendChoice backend) {
        Robot[] robot = new Robot[1];
        robot[0] = new Robot(Robot.settings(backend), time -> robot[0].kernel.charge(1));
        assertThatThrownBy(() -> robot[0].run(() -> robot[0].spin())).isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("cannot charge or block");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void theStepAtTheTimeLimitIsTheLastOne(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend).withLimitNanos(10 * MILLI), steps::add);
        ProgramEnd end = robot.run(robot::spin);
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.TIME_LIMIT);
        assertThat(end.timeNanos()).isEqualTo(10 * MILLI);
        assertThat(steps).hasSize(5).last().isEqualTo(10 * MILLI);
    }
}
