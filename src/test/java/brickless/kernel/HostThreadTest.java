package brickless.kernel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import handwritten.StaticAction;
import handwritten.StaticInitialiser;
import java.io.IOException;
import java.io.InputStream;
import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What the host's side of a program sees: thread locals, stacks that cannot be left, what remains after a run. */
class HostThreadTest {
    private static final String BACKENDS = "brickless.kernel.Backends#available";

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void eachProgramThreadHasItsOwnThreadLocals(BackendChoice backend) {
        ThreadLocal<String> local = ThreadLocal.withInitial(() -> "initial");
        Robot robot = new Robot(Robot.settings(backend));
        local.set("host");
        robot.run(() -> {
            for (String name : new String[] {"a", "b"}) {
                robot.start(name, () -> {
                    robot.log.add(local.get());
                    local.set(name);
                    robot.sleepMillis(5);
                    robot.log.add(local.get());
                });
            }
            local.set("main");
            robot.sleepMillis(20);
            robot.log.add(local.get());
        });
        assertThat(robot.log).containsExactly("initial", "initial", "a", "b", "main");
        assertThat(local.get()).isEqualTo("host");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void inheritableThreadLocalsComeFromTheStartingThreadAndNotFromTheHost(BackendChoice backend) {
        InheritableThreadLocal<String> local = new InheritableThreadLocal<>();
        Robot robot = new Robot(Robot.settings(backend));
        local.set("host");
        robot.run(() -> {
            robot.log.add("main " + local.get());
            local.set("parent");
            robot.start("child", () -> {
                robot.log.add("child " + local.get());
                local.set("changed");
            });
            robot.sleepMillis(5);
            robot.log.add("main " + local.get());
        });
        local.remove();
        assertThat(robot.log).containsExactly("main null", "child parent", "main parent");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void jdkCodeFindsTheProgramsClassLoader(BackendChoice backend) {
        ClassLoader loader = new ClassLoader(getClass().getClassLoader()) { };
        Robot robot = new Robot(Robot.settings(backend));
        Thread main = Robot.thread("main", () -> { });
        main.setContextClassLoader(loader);
        List<ClassLoader> seen = new ArrayList<>();
        robot.kernel.run(main, () -> {
            seen.add(Thread.currentThread().getContextClassLoader());
            robot.start("child", () -> seen.add(Thread.currentThread().getContextClassLoader()));
        });
        assertThat(seen).containsExactly(loader, loader);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void threadsInsideStaticInitialisersTakeTurnsInAnyOrder(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> {
            for (int i = 0; i < 4; i++) {
                int number = i;
                robot.start("init" + i, () -> initialiseFreshClass(() -> {
                    for (int round = 0; round < 3; round++) {
                        sleep(robot, 2 + (number + round) % 4);
                        robot.log.add(number + "." + round);
                    }
                }));
            }
            robot.start("plain", () -> {
                for (int round = 0; round < 3; round++) {
                    robot.sleepMillis(4);
                    robot.log.add("plain." + round);
                }
            });
        });
        // Sleeps of 2,3,4 / 3,4,5 / 4,5,2 / 5,2,3 ms, all from 2.5 ms on; who went to sleep first wakes first.
        assertThat(robot.log).containsExactly(
                "0.0", "1.0", "2.0", "plain.0", "3.0", "0.1", "1.1", "3.1", "plain.1", "2.1", "0.2", "3.2", "2.2",
                "1.2", "plain.2");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aProgramCanBeEndedInsideAStaticInitialiser(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend).withLimitNanos(10 * Robot.MILLI));
        ProgramEnd end = robot.run(() -> {
            robot.start("init", () -> initialiseFreshClass(() -> sleep(robot, 100)));
            robot.start("init", () -> initialiseFreshClass(() -> sleep(robot, 100)));
            robot.spin();
        });
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.TIME_LIMIT);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void nothingOfTheProgramRemains(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend).withLimitNanos(10 * Robot.MILLI));
        List<WeakReference<Object>> references = new ArrayList<>();
        runAndForget(robot, references);
        for (int i = 0; i < 50 && references.stream().anyMatch(reference -> reference.get() != null); i++) {
            System.gc();
        }
        assertThat(references).hasSize(2).allSatisfy(reference -> assertThat(reference.get()).isNull());
        assertThat(Thread.getAllStackTraces().keySet()).extracting(Thread::getName)
                .noneMatch(name -> name.contains("leftover"));
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void anInterruptOfTheHostThreadEndsTheProgram(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        Thread host = Thread.currentThread();
        List<String> unwound = new ArrayList<>();
        assertThatThrownBy(() -> robot.run(() -> {
            try {
                host.interrupt();
                robot.spin();
            } finally {
                unwound.add("main");
            }
        })).isInstanceOf(CancellationException.class);
        assertThat(Thread.interrupted()).isTrue();
        assertThat(unwound).containsExactly("main");
    }

    @Test
    void askingForContinuationsWhereThereAreNoneNamesTheOptions() {
        if (BackendChoice.continuationsAvailable()) {
            assertThat(new Robot(Robot.settings(BackendChoice.CONTINUATIONS)).run(() -> { }).status()).isZero();
        } else {
            Robot robot = new Robot(Robot.settings(BackendChoice.CONTINUATIONS));
            assertThatThrownBy(() -> robot.run(() -> { })).isInstanceOf(UnsupportedOperationException.class)
                    .hasMessageContaining(BackendChoice.CONTINUATION_OPTIONS);
        }
    }

    private static void runAndForget(Robot robot, List<WeakReference<Object>> references) {
        robot.run(() -> {
            Object lock = new Object();
            references.add(new WeakReference<>(lock));
            robot.start("leftover", () -> robot.locked(lock, () -> robot.sleepMillis(1_000)));
            Thread blocked = robot.start("leftover too", () -> robot.locked(lock, () -> { }));
            references.add(new WeakReference<>(blocked));
            robot.spin();
        });
    }

    private static void sleep(Robot robot, long millis) {
        Robot.runnable(() -> robot.sleepMillis(millis)).run();
    }

    /** Runs an action with a native frame of the JVM below it on the stack. */
    private static void initialiseFreshClass(Runnable action) throws ClassNotFoundException {
        StaticAction.set(action);
        Class.forName(StaticInitialiser.class.getName(), true, new FreshLoader());
    }

    /** Defines its own copy of {@link StaticInitialiser}. */
    private static final class FreshLoader extends ClassLoader {
        FreshLoader() {
            super(HostThreadTest.class.getClassLoader());
        }

        @Override
        protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
            if (!name.equals(StaticInitialiser.class.getName())) {
                return super.loadClass(name, resolve);
            }
            try (InputStream file = getResourceAsStream(name.replace('.', '/') + ".class")) {
                byte[] bytes = file.readAllBytes();
                return defineClass(name, bytes, 0, bytes.length);
            } catch (IOException e) {
                throw new ClassNotFoundException(name, e);
            }
        }
    }
}
