package brickless.kernel;

import static brickless.kernel.Robot.MILLI;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Robots whose clocks are driven on the stacks of others. */
class EnsembleStacksTest {
    private static final String BACKENDS = "brickless.kernel.Backends#available";
    private static final long LIMIT = 100 * MILLI;

    private static Robot robot(BackendChoice backend, long limit) {
        return new Robot(Robot.settings(backend).withLimitNanos(limit));
    }

    private static void main(Robot robot, Robot.Body body) {
        robot.kernel.main(Robot.thread("main", body), Robot.runnable(body));
    }

    private static List<ProgramEnd> run(StepHandler steps, Robot... robots) {
        return new Ensemble(List.of(robots).stream().map(robot -> robot.kernel).toList(), steps).run();
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aRobotThatRunsDrivesTheClocksOfThoseThatSleep(BackendChoice backend) {
        Robot first = robot(backend, LIMIT);
        Robot busy = robot(backend, LIMIT);
        Robot last = robot(backend, LIMIT);
        Set<Thread> hosts = new HashSet<>();
        main(first, () -> first.sleepMillis(51));
        Thread[] hostOfBusy = new Thread[1];
        main(busy, () -> {
            hostOfBusy[0] = Thread.currentThread();
            busy.spin();
        });
        main(last, () -> last.sleepMillis(51));
        run(time -> {
            if (time > 2 * MILLI && time <= 50 * MILLI) {
                hosts.add(Thread.currentThread());
            }
        }, first, busy, last);
        assertThat(hosts).containsExactly(hostOfBusy[0]);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void robotsThatAllSleepReachTheirTimesInOrder(BackendChoice backend) {
        Robot[] robots = {robot(backend, LIMIT), robot(backend, LIMIT), robot(backend, LIMIT)};
        List<String> order = new ArrayList<>();
        for (int i = 0; i < robots.length; i++) {
            int number = i;
            main(robots[i], () -> {
                for (int k = 0; k < 3; k++) {
                    robots[number].sleepMillis(5 + 2L * number);
                    order.add(number + " at " + robots[number].kernel.nowNanos() / MILLI);
                }
            });
        }
        run(time -> { }, robots);
        // What is due at a step belongs to the share that begins with it.
        assertThat(order).containsExactly(
                "0 at 5", "1 at 7", "2 at 9", "0 at 10", "0 at 15", "1 at 14", "2 at 18", "1 at 21", "2 at 27");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aProgramEndedInItsSleepUnwindsAtOnceAndTheOthersGoOn(BackendChoice backend) {
        Robot sleeper = robot(backend, LIMIT);
        Robot busy = robot(backend, LIMIT);
        long[] steppedUntil = new long[1];
        List<Long> unwound = new ArrayList<>();
        main(sleeper, () -> {
            try {
                sleeper.sleepMillis(1_000);
            } finally {
                unwound.add(steppedUntil[0]);
            }
        });
        main(busy, busy::spin);
        List<ProgramEnd> ends = run(time -> {
            steppedUntil[0] = time;
            if (time == 10 * MILLI) {
                sleeper.kernel.goalReached();
            }
        }, sleeper, busy);
        assertThat(ends).extracting(ProgramEnd::kind)
                .containsExactly(ProgramEnd.Kind.GOAL_REACHED, ProgramEnd.Kind.TIME_LIMIT);
        assertThat(unwound).containsExactly(10 * MILLI);
        assertThat(steppedUntil[0]).isEqualTo(LIMIT);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aProgramWhoseOnlyThreadNeverRanJustVanishes(BackendChoice backend) {
        Robot brief = robot(backend, LIMIT);
        Robot busy = robot(backend, LIMIT);
        main(brief, () -> {
            brief.kernel.charge(2 * MILLI - 1_000);
            brief.start("late", () -> brief.note("ran"));
        });
        main(busy, busy::spin);
        List<ProgramEnd> ends = run(time -> {
            if (time == 2 * MILLI) {
                brief.kernel.goalReached();
            }
        }, brief, busy);
        assertThat(ends).extracting(ProgramEnd::kind)
                .containsExactly(ProgramEnd.Kind.GOAL_REACHED, ProgramEnd.Kind.TIME_LIMIT);
        assertThat(brief.log).isEmpty();
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aCycleWithAJoinIsReportedWhileAnotherRobotsProgramRuns(BackendChoice backend) {
        Robot stuck = robot(backend, 20_000 * MILLI);
        Robot busy = robot(backend, 12_000 * MILLI);
        main(stuck, () -> {
            Thread[] threads = new Thread[2];
            threads[0] = stuck.start("left", () -> stuck.kernel.join(threads[1], 0));
            threads[1] = stuck.start("right", () -> stuck.kernel.join(threads[0], 0));
            stuck.sleepMillis(30_000);
        });
        main(busy, () -> {
            while (true) {
                busy.kernel.charge(MILLI);
            }
        });
        List<ProgramEnd> ends = run(time -> { }, stuck, busy);
        assertThat(ends).extracting(ProgramEnd::kind)
                .containsExactly(ProgramEnd.Kind.DEADLOCK, ProgramEnd.Kind.TIME_LIMIT);
        assertThat(ends.get(0).timeNanos() / MILLI).isEqualTo(10_001);
        assertThat(ends.get(0).dump().lines()).contains("\"main\" TIMED_WAITING",
                "\"left\" WAITING for the end of \"right\"", "\"right\" WAITING for the end of \"left\"");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void randomProgramsDoTogetherWhatEachDoesAlone(BackendChoice backend) {
        for (int seed = 0; seed < 20; seed++) {
            Robot[] together = new Robot[4];
            ScheduleHash[] hashes = new ScheduleHash[4];
            for (int i = 0; i < together.length; i++) {
                together[i] = randomProgram(backend, 4 * seed + i);
                hashes[i] = ScheduleHash.of(together[i].kernel);
            }
            List<ProgramEnd> ends = run(time -> { }, together);
            for (int i = 0; i < together.length; i++) {
                Robot alone = randomProgram(backend, 4 * seed + i);
                ScheduleHash hash = ScheduleHash.of(alone.kernel);
                assertThat(run(time -> { }, alone)).as("seed %d", 4 * seed + i).containsExactly(ends.get(i));
                assertThat(hashes[i]).as("seed %d", 4 * seed + i).isEqualTo(hash);
                assertThat(together[i].log).isEqualTo(alone.log);
                assertThat(together[i].kernel.contextSwitches()).isEqualTo(alone.kernel.contextSwitches());
            }
        }
    }

    /** Every second one with a schedule drawn from its seed. */
    private static Robot randomProgram(BackendChoice backend, int seed) {
        KernelSettings settings = Robot.settings(backend).withSeed(seed).withLimitNanos(1_000 * MILLI);
        Robot robot = new Robot(seed % 2 == 0 ? settings : settings.withScheduleSeed(seed));
        main(robot, () -> RandomProgram.run(robot));
        return robot;
    }
}
