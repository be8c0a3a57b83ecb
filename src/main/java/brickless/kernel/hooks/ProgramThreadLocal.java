package brickless.kernel.hooks;

import java.util.Objects;
import java.util.function.Supplier;

/**
 * What {@code new ThreadLocal} and {@code extends ThreadLocal} become in a rewritten program: values live in the
 * program thread. Per robot.
 */
public class ProgramThreadLocal<T> extends ThreadLocal<T> {
    @Override
    @SuppressWarnings("unchecked")
    public T get() {
        ThreadLocalValues values = ThreadLocalValues.ofCurrentThread();
        return values == null ? super.get() : (T) values.get(this, this::initialValue);
    }

    @Override
    public void set(T value) {
        ThreadLocalValues values = ThreadLocalValues.ofCurrentThread();
        if (values == null) {
            super.set(value);
        } else {
            values.set(this, value);
        }
    }

    @Override
    public void remove() {
        ThreadLocalValues values = ThreadLocalValues.ofCurrentThread();
        if (values == null) {
            super.remove();
        } else {
            values.remove(this);
        }
    }

    /** {@code ThreadLocal.withInitial}. */
    public static <S> ThreadLocal<S> withInitial(Supplier<? extends S> supplier) {
        Objects.requireNonNull(supplier);
        return new ProgramThreadLocal<S>() {
            @Override
            protected S initialValue() {
                return supplier.get();
            }
        };
    }
}
