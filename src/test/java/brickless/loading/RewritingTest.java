package brickless.loading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import brickless.kernel.hooks.Budget;
import brickless.kernel.hooks.InstructionCharges;
import brickless.kernel.hooks.ProgramKilled;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What each rewriter makes of small classes, seen from a machine that notes calls. */
class RewritingTest {
    private static final String FIXTURES = "brickless.loading.fixtures.";
    private static final int GRANT = 100_000_000;

    private final RecordingMachine machine = new RecordingMachine();
    private final RobotClassLoader loader = RobotClassLoader.ofApplication(RewritingTest.class.getClassLoader(),
            LoadingRules.standard().rewriting(FIXTURES));
    private Budget budget;

    @BeforeEach
    void bind() {
        budget = loader.bind(machine.machine());
        budget.grant(GRANT);
    }

    private Class<?> fixture(String name) throws ClassNotFoundException {
        return Class.forName(FIXTURES + name, true, loader);
    }

    private Object call(String fixture, String name, Object... arguments) throws Throwable {
        return callOn(null, fixture, name, arguments);
    }

    private Object callOn(Object receiver, String fixture, String name, Object... arguments) throws Throwable {
        Method method = Arrays.stream(fixture(fixture).getMethods())
                .filter(candidate -> candidate.getName().equals(name)).findFirst().get();
        try {
            return method.invoke(receiver, arguments);
        } catch (InvocationTargetException thrown) {
            throw thrown.getCause();
        }
    }

    private long spent() {
        return GRANT - budget.left();
    }

    @Test
    void everyRoundOfALoopIsCharged() throws Throwable {
        assertThat(call("Loops", "count", 10)).isEqualTo(45);
        assertThat(spent()).isEqualTo(10L * InstructionCharges.BACK_EDGE_NANOS);
    }

    @Test
    void codeWithoutLoopsAndCallsIsFree() throws Throwable {
        assertThat(call("Loops", "straight", 1, 2)).isEqualTo(2);
        assertThat(spent()).isZero();
    }

    @Test
    void jumpsBackOutOfASwitchAreCharged() throws Throwable {
        Object loops = fixture("Loops").getConstructor().newInstance();
        assertThat(callOn(loops, "Loops", "state", 5)).isEqualTo(5);
        assertThat(spent()).as("5 times continue, 5 times the test at the end")
                .isEqualTo(10L * InstructionCharges.BACK_EDGE_NANOS);
    }

    @Test
    void aPureSpinIsDearAndEntersTheKernelWhenTheBudgetEnds() throws Throwable {
        budget.grant(10 * InstructionCharges.PURE_SPIN_NANOS);
        Class<?> loops = fixture("Loops");
        int[] left = new int[1];
        machine.onBudgetExhausted = () -> {
            left[0] = budget.left();
            setTrue(loops);
        };
        call("Loops", "spin");
        assertThat(left[0]).isEqualTo(-InstructionCharges.PURE_SPIN_NANOS);
    }

    private static void setTrue(Class<?> loops) {
        try {
            loops.getField("done").set(null, true);
        } catch (ReflectiveOperationException impossible) {
            throw new AssertionError(impossible);
        }
    }

    @Test
    void anEmptyLambdaIsCharged() throws Throwable {
        Runnable lambda = (Runnable) call("Loops", "lambda");
        long before = spent();
        lambda.run();
        assertThat(spent() - before).isEqualTo(InstructionCharges.BACK_EDGE_NANOS);
    }

    @Test
    void synchronizedBlocksUseVirtualMonitors() throws Throwable {
        Object locks = fixture("Locks").getConstructor().newInstance();
        callOn(locks, "Locks", "block", "lock");
        assertThat(machine.calls).containsExactly("monitorEnter String", "monitorExit String");
    }

    @Test
    void aFailingBlockLeavesItsMonitor() throws Throwable {
        Object locks = fixture("Locks").getConstructor().newInstance();
        assertThatThrownBy(() -> callOn(locks, "Locks", "failingBlock", "lock"))
                .isInstanceOf(IllegalStateException.class);
        assertThat(machine.calls).containsExactly("monitorEnter String", "monitorExit String");
    }

    @Test
    void synchronizedMethodsUseVirtualMonitorsOfTheirObject() throws Throwable {
        Object locks = fixture("Locks").getConstructor().newInstance();
        assertThat(callOn(locks, "Locks", "method", 3L, 2.0, null)).isEqualTo(3L);
        assertThat(machine.calls).containsExactly("monitorEnter Locks", "monitorExit Locks");
    }

    @Test
    void aFailingSynchronizedMethodLeavesItsMonitor() throws Throwable {
        Object locks = fixture("Locks").getConstructor().newInstance();
        Object texts = new String[] {"a", null};
        assertThatThrownBy(() -> callOn(locks, "Locks", "failingMethod", texts))
                .isInstanceOf(IllegalStateException.class);
        assertThat(machine.calls).containsExactly("monitorEnter Locks", "monitorExit Locks");
    }

    @Test
    void staticSynchronizedMethodsLockTheirClass() throws Throwable {
        assertThat(call("Locks", "ofClass")).isEqualTo(1);
        assertThat(machine.calls).containsExactly("monitorEnter Class", "monitorExit Class");
    }

    @Test
    void waitAndNotifyGoToTheMachine() throws Throwable {
        Object locks = fixture("Locks").getConstructor().newInstance();
        callOn(locks, "Locks", "waiting", "lock");
        assertThat(machine.calls).containsExactly("monitorWait String 0", "monitorWait String 5000000",
                "monitorWait String 5000007",
                "monitorNotify String false", "monitorNotify String true");
    }

    @Test
    void threadCallsGoToTheMachine() throws Throwable {
        call("Calls", "threads", call("Calls", "thread", (Runnable) () -> { }));
        assertThat(machine.calls).containsExactly("sleep 5000000", "sleep 1000002", "sleep 1000000000",
                "yieldProcessor",
                "start ProgramThread", "join ProgramThread 3000000", "interrupt ProgramThread",
                "isAlive ProgramThread", "park 9",
                "unpark ProgramThread");
    }

    @Test
    void subclassesOfThreadKeepTheirOverrides() throws Throwable {
        Thread thread = (Thread) call("Calls", "myThread");
        thread.start();
        assertThat(thread.getClass().getField("started").get(thread)).isEqualTo(true);
        assertThat(machine.calls).containsExactly("start MyThread");
        assertThat(thread.getName()).isEqualTo("Thread-1");
    }

    @Test
    void clocksAreVirtual() throws Throwable {
        assertThat((long[]) call("Calls", "clocks")).containsExactly(1234, 1234);
    }

    @Test
    void randomnessIsSeeded() throws Throwable {
        int[] numbers = (int[]) call("Calls", "random");
        assertThat(numbers[0]).isEqualTo(new Random(1).nextInt());
        assertThat(numbers[1]).isEqualTo(new Random(2).nextInt());
    }

    @Test
    void theConsoleIsTheMachines() throws Throwable {
        call("Calls", "print", 0.1 + 0.2);
        assertThat(machine.printed.toString(StandardCharsets.UTF_8).replace("\r", ""))
                .isEqualTo("0.30000000000000004\nerror");
    }

    @Test
    void exitGoesToTheMachine() throws Throwable {
        call("Calls", "exit");
        assertThat(machine.calls).containsExactly("exit 7");
    }

    @Test
    void identityHashesAreDrawnOnce() throws Throwable {
        assertThat((int[]) call("Calls", "hashes")).containsExactly(1, 1, 1, 2, 3);
    }

    @Test
    void concatenationConvertsNumbersTheSameOnEveryJdk() throws Throwable {
        assertThat(call("Calls", "concatenated", 4 * Double.MIN_VALUE, 8 * Float.MIN_VALUE))
                .isEqualTo("a2.0E-3231.1E-441c");
    }

    @Test
    void arraysAreChargedByTheByte() throws Throwable {
        call("Calls", "arrays");
        long bytes = 4 * 4 + 100 * 4 + 3 * 8 + 10 * 4 + 2 * 8;
        assertThat(spent()).isEqualTo(bytes * InstructionCharges.ALLOCATION_NANOS_PER_BYTE);
    }

    @Test
    void anArrayThatTheBrickCouldNotHoldIsRefused() {
        assertThatThrownBy(() -> call("Calls", "large")).isInstanceOf(OutOfMemoryError.class);
    }

    @Test
    void theEndOfTheProgramPassesEveryHandler() throws Throwable {
        machine.killing = true;
        Runnable killed = () -> {
            throw new ProgramKilled();
        };
        for (String handler : new String[] {"everything", "errors", "returningFinally", "locked"}) {
            assertThatThrownBy(() -> call("Handlers", handler, killed)).as(handler).isInstanceOf(ProgramKilled.class);
        }
        assertThat(fixture("Handlers").getField("swallowed").get(null)).isEqualTo(0);
    }

    @Test
    void otherErrorsAreSwallowedAsWritten() throws Throwable {
        Runnable failing = () -> {
            throw new AssertionError();
        };
        call("Handlers", "everything", failing);
        call("Handlers", "errors", failing);
        assertThat(call("Handlers", "returningFinally", failing)).isEqualTo(1);
        assertThat(fixture("Handlers").getField("swallowed").get(null)).isEqualTo(3);
    }

    @Test
    void callDepthIsRestoredAfterExceptions() throws Throwable {
        assertThat(call("Handlers", "caught", 50)).isEqualTo(2);
        assertThat(budget.depth()).isZero();
    }

    @Test
    void tooDeepRecursionOverflowsAndOneLessDoesNot() throws Throwable {
        assertThat(call("Handlers", "recurse", InstructionCharges.LARGEST_CALL_DEPTH - 1))
                .isEqualTo(InstructionCharges.LARGEST_CALL_DEPTH - 1);
        assertThatThrownBy(() -> call("Handlers", "recurse", InstructionCharges.LARGEST_CALL_DEPTH))
                .isInstanceOf(StackOverflowError.class);
    }

    @Test
    void initialisersThatMayBlockRunAtFirstUse() throws Throwable {
        Class<?> type = fixture("Initialised");
        assertThat(type.getField("value").get(null)).as("not initialised by the JVM").isEqualTo(0);
        assertThat(call("Initialised$User", "read")).isEqualTo(9);
        assertThat(type.getField("value").get(null)).isEqualTo(6);
    }

    @Test
    void initialisersThatOnlyComputeRunAtFirstUseWithoutAMonitor() throws Throwable {
        Class<?> type = fixture("Initialised$Harmless");
        assertThat(type.getField("TABLE").get(null)).as("not initialised by the JVM").isNull();
        assertThat(call("Initialised$User", "third")).isEqualTo(3);
        assertThat(machine.calls).containsExactly("undivided true", "undivided false");
    }

    @Test
    void nativeMethodsSayWhatIsWrongWhenCalled() {
        assertThatThrownBy(() -> call("Calls", "nativeMethod")).isInstanceOf(UnsatisfiedLinkError.class)
                .hasMessageContaining(FIXTURES + "Calls.nativeMethod").hasMessageContaining("virtual brick");
    }

    @Test
    void finalizersAreNotForTheCollector() throws Throwable {
        assertThat(fixture("Calls").getDeclaredMethods()).noneMatch(method -> method.getName().equals("finalize"));
    }
}
