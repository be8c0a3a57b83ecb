package brickless.loading;

import brickless.kernel.hooks.Budget;
import brickless.kernel.hooks.VirtualMachine;
import java.lang.invoke.MethodHandles;
import java.lang.reflect.Constructor;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.function.Consumer;

/** Calls into a robot's own classes from outside, by reflection: its hooks, its threads and its main method. */
final class ProgramEntry {
    private static final String HOOKS_PACKAGE = "brickless.kernel.hooks.";

    private ProgramEntry() {}

    static Budget bind(ClassLoader robot, VirtualMachine kernel) {
        return (Budget) call(hook(robot, "Hooks", "bind", VirtualMachine.class), kernel);
    }

    static void listen(ClassLoader robots, Consumer<Class<?>> onInitialisation) {
        call(hook(robots, "Hooks", "listen", Consumer.class), onInitialisation);
    }

    static MethodHandles.Lookup insideOf(Class<?> type) {
        return (MethodHandles.Lookup) call(
                hook(type.getClassLoader(), "ReflectionHooks", "insideOf", Class.class), type);
    }

    static Thread newThread(ClassLoader robot, Runnable body, String name) {
        try {
            Constructor<?> constructor = robot.loadClass(HOOKS_PACKAGE + "ProgramThread")
                    .getConstructor(Runnable.class, String.class);
            return (Thread) constructor.newInstance(body, name);
        } catch (ReflectiveOperationException broken) {
            throw new LinkageError("thread class of the robot", broken);
        }
    }

    /** Initialises the class on the calling fibre and calls its main method. */
    static void callMain(ClassLoader robot, String mainClass, String[] arguments) {
        call(mainMethod(initialized(robot, mainClass)), arguments);
    }

    static Class<?> initialized(ClassLoader robot, String name) {
        return (Class<?>) call(hook(robot, "ReflectionHooks", "forName", String.class), name);
    }

    private static Method mainMethod(Class<?> type) {
        try {
            Method main = type.getMethod("main", String[].class);
            if (!Modifier.isStatic(main.getModifiers()) || main.getReturnType() != void.class) {
                throw new IllegalArgumentException("main of " + type.getName()
                        + " is not 'public static void main(String[])'");
            }
            main.setAccessible(true);
            return main;
        } catch (NoSuchMethodException absent) {
            throw new IllegalArgumentException(type.getName() + " has no 'public static void main(String[])'", absent);
        }
    }

    private static Method hook(ClassLoader robot, String type, String name, Class<?>... parameters) {
        try {
            return robot.loadClass(HOOKS_PACKAGE + type).getMethod(name, parameters);
        } catch (ReflectiveOperationException broken) {
            throw new LinkageError("hooks of the robot", broken);
        }
    }

    /** Through a method handle: a fibre below a reflection frame of the JVM could not be switched away. */
    private static Object call(Method method, Object argument) {
        try {
            return MethodHandles.publicLookup().unreflect(method).invoke(argument);
        } catch (IllegalAccessException broken) {
            throw new LinkageError(method.toString(), broken);
        } catch (Throwable thrown) {
            throw ProgramEntry.<RuntimeException>unchecked(thrown);
        }
    }

    /** Throws an exception of the program as it is. */
    @SuppressWarnings("unchecked")
    private static <E extends Throwable> E unchecked(Throwable failure) throws E {
        throw (E) failure;
    }
}
