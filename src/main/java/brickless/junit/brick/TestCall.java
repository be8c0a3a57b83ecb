package brickless.junit.brick;

import java.lang.annotation.Annotation;
import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.platform.commons.support.AnnotationSupport;
import org.junit.platform.commons.support.HierarchyTraversalMode;

/** Calls a test inside the robot: constructor, {@code @BeforeEach} methods, test, {@code @AfterEach} methods; then ends the program. */
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

    @Override public void run() {
        Throwable failure = outcome();
        if (failure != null) {
            Thread.getDefaultUncaughtExceptionHandler().uncaughtException(Thread.currentThread(), failure);
        }
        done.accept(failure);
        System.exit(failure == null ? 0 : 1);
    }

    private Throwable outcome() {
        try {
            Class<?> test = Class.forName(type);
            Object instance = instance(test, test.isMemberClass() ? test.getDeclaringClass() : null);
            return lifeCycle(test, instance);
        } catch (InvocationTargetException e) {
            return e.getCause();
        } catch (ReflectiveOperationException | RuntimeException | Error e) {
            return e;
        }
    }

    private Throwable lifeCycle(Class<?> test, Object instance) throws ReflectiveOperationException {
        Throwable failure = thrownBy(() -> {
            callAll(test, instance, BeforeEach.class, HierarchyTraversalMode.TOP_DOWN);
            method(test).invoke(instance, arguments);
        });
        Throwable late = thrownBy(() -> callAll(test, instance, AfterEach.class, HierarchyTraversalMode.BOTTOM_UP));
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

    private static void callAll(Class<?> test, Object instance, Class<? extends Annotation> annotation, HierarchyTraversalMode order)
            throws ReflectiveOperationException {
        List<Method> methods = AnnotationSupport.findAnnotatedMethods(test, annotation, order);
        for (Method each : methods) {
            each.setAccessible(true);
            if (each.getParameterCount() > 0) {
                throw new IllegalArgumentException(each.getName() + ": methods around a test @OnTheBrick have no parameters");
            }
            each.invoke(instance);
        }
    }

    /** A nested test class needs an instance of its outer class, made first. */
    private static Object instance(Class<?> test, Class<?> outer) throws ReflectiveOperationException {
        Constructor<?> constructor = test.getDeclaredConstructors()[0];
        constructor.setAccessible(true);
        if (constructor.getParameterCount() == 0) {
            return constructor.newInstance();
        }
        if (outer != null && constructor.getParameterCount() == 1 && constructor.getParameterTypes()[0] == outer) {
            return constructor.newInstance(instance(outer, outer.isMemberClass() ? outer.getDeclaringClass() : null));
        }
        throw new IllegalArgumentException(test.getName() + ": a class with tests @OnTheBrick has a constructor without parameters");
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
