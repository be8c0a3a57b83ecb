package brickless.junit;

import brickless.simulation.Run;
import brickless.simulation.Simulation;
import java.lang.reflect.Method;
import java.util.Optional;
import org.junit.jupiter.api.extension.AfterEachCallback;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.InvocationInterceptor;
import org.junit.jupiter.api.extension.ParameterContext;
import org.junit.jupiter.api.extension.ParameterResolutionException;
import org.junit.jupiter.api.extension.ParameterResolver;
import org.junit.jupiter.api.extension.ReflectiveInvocationContext;
import org.junit.platform.commons.support.AnnotationSupport;

/**
 * Resolves parameters of type {@link Simulation} and {@link Run}, runs {@link OnTheBrick} tests in the simulation, and
 * tells about the runs of a test that failed. Has no state: what belongs to a test is in its {@link ExtensionContext}.
 * Comes with the annotations of this package.
 */
public final class SimulationExtension implements ParameterResolver, InvocationInterceptor, AfterEachCallback {
    /** Creates the extension; JUnit does. */
    public SimulationExtension() {}

    @Override
    public boolean supportsParameter(ParameterContext parameter, ExtensionContext context) {
        Class<?> type = parameter.getParameter().getType();
        return type == Simulation.class || type == Run.class;
    }

    @Override
    public Object resolveParameter(ParameterContext parameter, ExtensionContext context) {
        if (context.getTestMethod().isEmpty()) {
            throw new ParameterResolutionException(
                    "every test has its own simulation: constructors and @BeforeAll methods cannot have one");
        }
        if (onTheBrick(context)) {
            throw new ParameterResolutionException("a test @OnTheBrick is inside the simulation and cannot hold it");
        }
        TestSimulation simulation = TestSimulation.of(context);
        return parameter.getParameter().getType() == Run.class ? simulation.run() : simulation.simulation();
    }

    @Override
    public void interceptTestMethod(Invocation<Void> invocation, ReflectiveInvocationContext<Method> call,
            ExtensionContext context)
            throws Throwable {
        test(invocation, call, context);
    }

    @Override
    public void interceptTestTemplateMethod(Invocation<Void> invocation,
            ReflectiveInvocationContext<Method> call,
            ExtensionContext context) throws Throwable {
        test(invocation, call, context);
    }

    private static void test(Invocation<Void> invocation, ReflectiveInvocationContext<Method> call,
            ExtensionContext context) throws Throwable {
        if (onTheBrick(context)) {
            invocation.skip();
            new BrickTest(TestSimulation.of(context).simulation(), call).run();
        } else {
            invocation.proceed();
        }
    }

    @Override
    public void interceptBeforeEachMethod(Invocation<Void> invocation,
            ReflectiveInvocationContext<Method> call,
            ExtensionContext context) throws Throwable {
        outsideOnly(invocation, context);
    }

    @Override
    public void interceptAfterEachMethod(Invocation<Void> invocation,
            ReflectiveInvocationContext<Method> call,
            ExtensionContext context) throws Throwable {
        outsideOnly(invocation, context);
    }

    private static void outsideOnly(Invocation<Void> invocation, ExtensionContext context) throws Throwable {
        if (onTheBrick(context)) {
            invocation.skip();
        } else {
            invocation.proceed();
        }
    }

    private static boolean onTheBrick(ExtensionContext context) {
        Optional<OnTheBrick> annotation = AnnotationSupport.findAnnotation(context.getTestMethod(), OnTheBrick.class);
        return annotation.isPresent()
                || AnnotationSupport.findAnnotation(context.getRequiredTestClass(), OnTheBrick.class,
                context.getEnclosingTestClasses()).isPresent();
    }

    @Override
    public void afterEach(ExtensionContext context) {
        TestSimulation.of(context).close(context.getExecutionException());
    }
}
