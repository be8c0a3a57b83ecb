package brickless.junit.brick;

import java.lang.annotation.Annotation;
import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.platform.commons.support.AnnotationSupport;
import org.junit.platform.commons.support.HierarchyTraversalMode;

/**
 * Calls a test inside the robot: constructor, {@code @BeforeEach} methods, test, {@code @AfterEach} methods; then ends
 * the program.
 */
public final class TestCall implements Runnable {
    private final String type;
    private final String method;
    private final String[] parameters;
    private final Object[] arguments;
    private final Consumer<Throwable> done;

    /**
     * Creates a call.
     *
     * @param type test class
     * @param method test method
     * @param parameters names of its parameter types
     * @param arguments its arguments
     * @param done told what the test threw, or null
     */
    public TestCall(String type, String method, String[] parameters, Object[] arguments, Consumer<Throwable> done) {
        this.type = type;
        this.method = method;
        this.parameters = parameters;
        this.arguments = arguments;
        this.done = done;
    }

    @Override
    public void run() {
        Throwable failure = outcome();
        if (failure != null) {
            Thread.getDefaultUncaughtExceptionHandler().uncaughtException(Thread.currentThread(), failure);
        }
        done.accept(failure);
        System.exit(failure == null ? 0 : 1);
    }

    private Throwable outcome() {
        try {
            return lifeCycle(instances(Class.forName(type)));
        } catch (InvocationTargetException e) {
            return e.getCause();
        } catch (ReflectiveOperationException | RuntimeException | Error e) {
            return e;
        }
    }

    private Throwable lifeCycle(List<Object> instances) throws ReflectiveOperationException {
        Object innermost = instances.get(instances.size() - 1);
        Throwable failure = thrownBy(() -> {
            for (Object instance : instances) {
                callAll(instance, BeforeEach.class, HierarchyTraversalMode.TOP_DOWN);
            }
            method(innermost.getClass()).invoke(innermost, arguments);
        });
        Throwable late = thrownBy(() -> {
            for (int i = instances.size() - 1; i >= 0; i--) {
                callAll(instances.get(i), AfterEach.class, HierarchyTraversalMode.BOTTOM_UP);
            }
        });
        if (failure != null && late != null) {
            failure.addSuppressed(late);
        }
        return failure != null ? failure : late;
    }

    private interface Part {
        void run() throws ReflectiveOperationException;
    }

    private static Throwable thrownBy(Part part) throws ReflectiveOperationException {
        try {
            part.run();
            return null;
        } catch (InvocationTargetException e) {
            return e.getCause();
        }
    }

    private static void callAll(Object instance, Class<? extends Annotation> annotation, HierarchyTraversalMode order)
            throws ReflectiveOperationException {
        for (Method each : AnnotationSupport.findAnnotatedMethods(instance.getClass(), annotation, order)) {
            each.setAccessible(true);
            if (each.getParameterCount() > 0) {
                throw new IllegalArgumentException(each.getName()
                        + ": methods around a test @OnTheBrick have no parameters");
            }
            each.invoke(instance);
        }
    }

    /** An instance of the test class, behind those of its outer classes if it is a nested one, outermost first. */
    private static List<Object> instances(Class<?> test) throws ReflectiveOperationException {
        boolean nested = test.isMemberClass() && !Modifier.isStatic(test.getModifiers());
        List<Object> instances = nested ? instances(test.getDeclaringClass()) : new ArrayList<>();
        Constructor<?> constructor = test.getDeclaredConstructors()[0];
        if (constructor.getParameterCount() != (nested ? 1 : 0)) {
            throw new IllegalArgumentException(test.getName()
                    + ": a class with tests @OnTheBrick has one constructor, without parameters");
        }
        constructor.setAccessible(true);
        instances.add(nested ? constructor.newInstance(instances.get(instances.size() - 1))
                : constructor.newInstance());
        return instances;
    }

    private Method method(Class<?> test) {
        for (Class<?> each = test; each != null; each = each.getSuperclass()) {
            for (Method candidate : each.getDeclaredMethods()) {
                if (candidate.getName().equals(method) && sameParameters(candidate)) {
                    candidate.setAccessible(true);
                    return candidate;
                }
            }
        }
        throw new IllegalStateException("the robot's copy of " + test.getName() + " must have " + method);
    }

    private boolean sameParameters(Method candidate) {
        Class<?>[] types = candidate.getParameterTypes();
        if (types.length != parameters.length) {
            return false;
        }
        for (int i = 0; i < types.length; i++) {
            if (!types[i].getName().equals(parameters[i])) {
                return false;
            }
        }
        return true;
    }
}
