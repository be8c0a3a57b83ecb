package brickless.kernel.hooks;

import java.util.IdentityHashMap;
import java.util.Map;
import java.util.function.Supplier;

/**
 * The thread-local values of one program thread, kept in its {@link ProgramThread}: several fibres may share one JDK
 * thread, and values left in a JDK thread would keep the program's classes alive. Per robot; used by the owning fibre
 * only.
 */
final class ThreadLocalValues {
    private final Map<ThreadLocal<?>, Object> values = new IdentityHashMap<>();

    /** The values of the running thread; null if it is not a program thread. */
    static ThreadLocalValues ofCurrentThread() {
        Thread current = Hooks.machine().currentThread();
        return current instanceof ProgramThread ? ((ProgramThread) current).localValues() : null;
    }

    /** What a thread that the running thread creates starts with. */
    static ThreadLocalValues inheritedFromCurrentThread() {
        ThreadLocalValues inherited = new ThreadLocalValues();
        ThreadLocalValues parent = ofCurrentThread();
        if (parent != null) {
            parent.values.forEach((key, value) -> {
                if (key instanceof ProgramInheritableThreadLocal) {
                    inherited.values.put(key, ((ProgramInheritableThreadLocal<?>) key).inherited(value));
                }
            });
        }
        return inherited;
    }

    /** The value under {@code key}; drawn from {@code initial} and kept at first use. */
    Object get(ThreadLocal<?> key, Supplier<?> initial) {
        if (!values.containsKey(key)) {
            Object value = initial.get();
            values.put(key, value);
            return value;
        }
        return values.get(key);
    }

    void set(ThreadLocal<?> key, Object value) {
        values.put(key, value);
    }

    void remove(ThreadLocal<?> key) {
        values.remove(key);
    }
}
