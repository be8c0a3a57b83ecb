package brickless.kernel;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;

/**
 * The JDK's internal continuations and the thread locals of a carrier, through method handles, because neither can be
 * named in source for JDK 17. Constants only: either all handles are there or {@link #OBSTACLE} says what is missing.
 */
final class ContinuationAccess {
    /** What this JVM lacks, or null if continuations work. */
    static final String OBSTACLE;

    private static final int FIRST_JDK = 21;
    private static final String CONTINUATION = "jdk.internal.vm.Continuation";
    private static final String SCOPE = "jdk.internal.vm.ContinuationScope";

    /** (Runnable) → continuation. */
    private static final MethodHandle NEW;
    /** (continuation) → void. */
    private static final MethodHandle RUN;
    /** () → boolean. */
    private static final MethodHandle YIELD;
    /** (continuation) → frames. */
    private static final MethodHandle STACK;
    private static final FieldHandles LOCALS;
    private static final FieldHandles INHERITABLE_LOCALS;

    static {
        MethodHandle[] handles = new MethodHandle[4];
        FieldHandles[] locals = new FieldHandles[2];
        OBSTACLE = look(handles, locals);
        NEW = handles[0];
        RUN = handles[1];
        YIELD = handles[2];
        STACK = handles[3];
        LOCALS = locals[0];
        INHERITABLE_LOCALS = locals[1];
    }

    private ContinuationAccess() {
    }

    /** Access to a field of {@code Thread}. */
    private record FieldHandles(MethodHandle getter, MethodHandle setter) {
        static FieldHandles of(MethodHandles.Lookup lookup, String name) throws ReflectiveOperationException {
            Class<?> type = Class.forName("java.lang.ThreadLocal$ThreadLocalMap");
            MethodType get = MethodType.methodType(Object.class, Thread.class);
            MethodType set = MethodType.methodType(void.class, Thread.class, Object.class);
            return new FieldHandles(lookup.findGetter(Thread.class, name, type).asType(get),
                    lookup.findSetter(Thread.class, name, type).asType(set));
        }
    }

    /** A continuation that will execute {@code target}. */
    static Object create(Runnable target) {
        try {
            return (Object) NEW.invokeExact(target);
        } catch (Throwable e) {
            throw unchecked(e);
        }
    }

    /** Executes a continuation on the calling thread until it yields or ends. */
    static void run(Object continuation) {
        try {
            RUN.invokeExact(continuation);
        } catch (Throwable e) {
            throw unchecked(e);
        }
    }

    /**
     * Leaves the running continuation.
     *
     * @return true once it was run again; false at once if its stack cannot be moved, because it holds a native frame
     *     or a JVM monitor
     */
    static boolean yield() {
        try {
            return (boolean) YIELD.invokeExact();
        } catch (IllegalStateException pinned) {
            // What Continuation.onPinned throws unless it is overridden, after the failed attempt was cleaned up.
            return false;
        } catch (Throwable e) {
            throw unchecked(e);
        }
    }

    /** The frames of a continuation that does not run. */
    static StackTraceElement[] stackOf(Object continuation) {
        try {
            return (StackTraceElement[]) STACK.invokeExact(continuation);
        } catch (Throwable e) {
            throw unchecked(e);
        }
    }

    static Object locals(Thread thread) {
        return get(LOCALS, thread);
    }

    static Object inheritableLocals(Thread thread) {
        return get(INHERITABLE_LOCALS, thread);
    }

    static void setLocals(Thread thread, Object locals, Object inheritable) {
        try {
            LOCALS.setter.invokeExact(thread, locals);
            INHERITABLE_LOCALS.setter.invokeExact(thread, inheritable);
        } catch (Throwable e) {
            throw unchecked(e);
        }
    }

    private static Object get(FieldHandles field, Thread thread) {
        try {
            return (Object) field.getter.invokeExact(thread);
        } catch (Throwable e) {
            throw unchecked(e);
        }
    }

    private static String look(MethodHandle[] handles, FieldHandles[] locals) {
        if (Runtime.version().feature() < FIRST_JDK) {
            return "this is JDK " + Runtime.version().feature();
        }
        try {
            MethodHandles.Lookup lookup = MethodHandles.lookup();
            Class<?> type = Class.forName(CONTINUATION);
            Class<?> scopeType = Class.forName(SCOPE);
            Object scope = lookup.findConstructor(scopeType, MethodType.methodType(void.class, String.class))
                    .invoke("brickless");
            handles[0] = lookup.findConstructor(type, MethodType.methodType(void.class, scopeType, Runnable.class))
                    .bindTo(scope).asType(MethodType.methodType(Object.class, Runnable.class));
            handles[1] = lookup.findVirtual(type, "run", MethodType.methodType(void.class))
                    .asType(MethodType.methodType(void.class, Object.class));
            handles[2] = lookup.findStatic(type, "yield", MethodType.methodType(boolean.class, scopeType))
                    .bindTo(scope);
            handles[3] = lookup.findVirtual(type, "getStackTrace", MethodType.methodType(StackTraceElement[].class))
                    .asType(MethodType.methodType(StackTraceElement[].class, Object.class));
            MethodHandles.Lookup inThread = MethodHandles.privateLookupIn(Thread.class, lookup);
            locals[0] = FieldHandles.of(inThread, "threadLocals");
            locals[1] = FieldHandles.of(inThread, "inheritableThreadLocals");
            return null;
        } catch (Throwable e) {
            return e.toString();
        }
    }

    private static RuntimeException unchecked(Throwable e) {
        if (e instanceof Error error) {
            throw error;
        }
        return e instanceof RuntimeException exception ? exception : new IllegalStateException(e);
    }
}
