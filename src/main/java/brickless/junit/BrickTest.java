package brickless.junit;

import brickless.simulation.Outcome;
import brickless.simulation.Run;
import brickless.simulation.Simulation;
import java.lang.reflect.Constructor;
import java.lang.reflect.Method;
import java.util.Arrays;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import org.junit.jupiter.api.extension.ReflectiveInvocationContext;
import org.opentest4j.AssertionFailedError;

/** One {@link OnTheBrick} test: runs it as the program of a robot and passes on how it came out. */
final class BrickTest {
    /** Runs inside the robot; named, not referred to: the robot has its own copy of the class. */
    private static final String CALL = "brickless.junit.brick.TestCall";

    private record Verdict(Throwable failure) {}

    private final Simulation simulation;
    private final Class<?> type;
    private final Method method;
    private final Object[] arguments;

    BrickTest(Simulation simulation, ReflectiveInvocationContext<Method> call) {
        this.simulation = simulation;
        type = call.getTargetClass();
        method = call.getExecutable();
        arguments = call.getArguments().toArray();
    }

    void run() throws Throwable {
        AtomicReference<Verdict> verdict = new AtomicReference<>();
        Run run = simulation.start(type, robot -> call(robot, failure -> verdict.set(new Verdict(failure))).run());
        run.toEnd();
        if (verdict.get() == null) {
            throw unfinished(run.outcome());
        }
        if (verdict.get().failure() != null) {
            throw verdict.get().failure();
        }
    }

    private Runnable call(ClassLoader robot, Consumer<Throwable> done) throws ReflectiveOperationException {
        String[] parameters = Arrays.stream(method.getParameterTypes()).map(Class::getName).toArray(String[]::new);
        Constructor<?> constructor = robot.loadClass(CALL).getConstructor(String.class, String.class, String[].class,
                Object[].class, Consumer.class);
        return (Runnable) constructor.newInstance(type.getName(), method.getName(), parameters, arguments, done);
    }

    private AssertionFailedError unfinished(Outcome outcome) {
        String how = switch (outcome.kind()) {
            case "time-limit" -> "did not end within " + Seconds.text(simulation.settings().limit())
                    + " simulated seconds (@Simulated(seconds = …) allows more)";
            case "exited" -> "ended the program with status " + outcome.exitStatus().orElse(0) + " before it returned";
            default -> "ended in a " + outcome.kind();
        };
        return new AssertionFailedError("the test " + how + outcome.error().map(error -> "\n" + error).orElse(""));
    }
}
