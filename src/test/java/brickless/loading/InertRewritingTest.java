package brickless.loading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import brickless.loading.fixtures.Calls;
import brickless.loading.fixtures.Handlers;
import brickless.loading.fixtures.Loops;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

/** Without a kernel, rewritten classes do what the plain ones do, on real threads. */
class InertRewritingTest {
    private static final String FIXTURES = "brickless.loading.fixtures.";

    private final RobotClassLoader loader = RobotClassLoader.ofApplication(InertRewritingTest.class.getClassLoader(),
            LoadingRules.standard().rewriting(FIXTURES));

    private Object call(Object receiver, String fixture, String name, Object... arguments) throws Throwable {
        Class<?> type = Class.forName(FIXTURES + fixture, true, loader);
        Method method = Arrays.stream(type.getMethods()).filter(candidate -> candidate.getName().equals(name))
                .findFirst().get();
        try {
            return method.invoke(receiver, arguments);
        } catch (InvocationTargetException thrown) {
            throw thrown.getCause();
        }
    }

    @Test
    void resultsAreThoseOfThePlainClasses() throws Throwable {
        assertThat(call(null, "Loops", "count", 1000)).isEqualTo(Loops.count(1000));
        assertThat(call(null, "Handlers", "caught", 5)).isEqualTo(Handlers.caught(5));
        assertThat(call(null, "Handlers", "recurse", 5000)).isEqualTo(5000);
        assertThat(call(null, "Calls", "concatenated", 1.5, "x")).isEqualTo(Calls.concatenated(1.5, "x"));
    }

    @Test
    void monitorsWorkAcrossRealThreads() throws Throwable {
        Object locks = Class.forName(FIXTURES + "Locks", true, loader).getConstructor().newInstance();
        Thread[] threads = new Thread[4];
        for (int i = 0; i < threads.length; i++) {
            threads[i] = (Thread) call(null, "Calls", "thread", (Runnable) () -> addThousand(locks));
            threads[i].start();
        }
        for (Thread thread : threads) {
            thread.join();
        }
        assertThat(locks.getClass().getField("value").get(locks)).isEqualTo(4000);
    }

    private void addThousand(Object locks) {
        try {
            for (int i = 0; i < 1000; i++) {
                call(locks, "Locks", "block", locks);
            }
        } catch (Throwable failure) {
            throw new AssertionError(failure);
        }
    }

    @Test
    void waitingWithoutTheMonitorIsRefused() throws Throwable {
        Object locks = Class.forName(FIXTURES + "Locks", true, loader).getConstructor().newInstance();
        assertThatThrownBy(() -> call(locks, "Locks", "waiting", "lock"))
                .isInstanceOf(IllegalMonitorStateException.class);
    }

    @Test
    void initialisersRunAtFirstUse() throws Throwable {
        assertThat(call(null, "Initialised$User", "read")).isEqualTo(9);
    }

    @Test
    void clocksAreTheHosts() throws Throwable {
        long[] clocks = (long[]) call(null, "Calls", "clocks");
        assertThat(clocks[0]).isGreaterThan(1_000_000_000_000L);
    }
}
