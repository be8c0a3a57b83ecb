package brickless.kernel.hooks;

import java.lang.invoke.MethodHandles;
import java.lang.reflect.AccessibleObject;
import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;

/**
 * Reflection of rewritten code: classes are initialised on fibres first, and methods that rewriting redirects are
 * redirected here too. Access checks are more permissive than the JDK's, because the caller seen is this class. Per
 * robot.
 */
public final class ReflectionHooks {
    private static final MethodHandles.Lookup LOOKUP = MethodHandles.lookup();

    private ReflectionHooks() {}

    /** Full access to a class of the robot, for its loader and for hooks. */
    public static MethodHandles.Lookup insideOf(Class<?> type) throws IllegalAccessException {
        return MethodHandles.privateLookupIn(type, LOOKUP);
    }

    /** {@code Class.forName(name)}. */
    public static Class<?> forName(String name) throws ClassNotFoundException {
        return forName(name, true, ReflectionHooks.class.getClassLoader());
    }

    /** {@code Class.forName(name, initialize, loader)}. */
    public static Class<?> forName(String name, boolean initialize, ClassLoader loader) throws ClassNotFoundException {
        if (initialize) {
            ClassInitialization.initializeForReflection(Class.forName(name, false, loader));
        }
        return Class.forName(name, initialize, loader);
    }

    /** {@code type.newInstance()}. */
    public static Object newInstance(Class<?> type) throws InstantiationException, IllegalAccessException {
        try {
            return newInstance(type.getDeclaredConstructor(), new Object[0]);
        } catch (NoSuchMethodException absent) {
            throw (InstantiationException) new InstantiationException(type.getName()).initCause(absent);
        } catch (InvocationTargetException thrown) {
            throw ReflectionHooks.<RuntimeException>unchecked(thrown.getCause());
        }
    }

    /** {@code constructor.newInstance(arguments)}. */
    public static Object newInstance(Constructor<?> constructor, Object[] arguments)
            throws InstantiationException, IllegalAccessException, InvocationTargetException {
        ClassInitialization.initializeForReflection(constructor.getDeclaringClass());
        makeAccessible(constructor, constructor.getDeclaringClass());
        return constructor.newInstance(arguments);
    }

    /** {@code method.invoke(receiver, arguments)}. */
    public static Object invoke(Method method, Object receiver, Object[] arguments)
            throws IllegalAccessException, InvocationTargetException {
        Method hook = RedirectedMethods.hookFor(method);
        if (hook != null) {
            return hook.invoke(null, Modifier.isStatic(method.getModifiers()) ? arguments
                    : withReceiver(receiver, arguments));
        }
        if (Modifier.isStatic(method.getModifiers())) {
            ClassInitialization.initializeForReflection(method.getDeclaringClass());
        }
        makeAccessible(method, method.getDeclaringClass());
        return method.invoke(receiver, arguments);
    }

    private static Object[] withReceiver(Object receiver, Object[] arguments) {
        int count = arguments == null ? 0 : arguments.length;
        Object[] all = new Object[count + 1];
        all[0] = receiver;
        if (count > 0) {
            System.arraycopy(arguments, 0, all, 1, count);
        }
        return all;
    }

    /** The program's own members stay reachable though this class makes the call. */
    static void makeAccessible(AccessibleObject member, Class<?> owner) {
        if (owner.getClassLoader() == ReflectionHooks.class.getClassLoader()) {
            member.setAccessible(true);
        }
    }

    /** Throws any exception as it is: those of initialisers, for instance, must not be wrapped twice. */
    @SuppressWarnings("unchecked")
    static <E extends Throwable> E unchecked(Throwable failure) throws E {
        throw (E) failure;
    }
}
