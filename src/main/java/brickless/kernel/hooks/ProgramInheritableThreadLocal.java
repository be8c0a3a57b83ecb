package brickless.kernel.hooks;

/**
 * What {@code new InheritableThreadLocal} and {@code extends InheritableThreadLocal} become in a rewritten program:
 * values live in the program thread. Per robot.
 */
public class ProgramInheritableThreadLocal<T> extends InheritableThreadLocal<T> {
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

    /** What a child thread gets when its parent holds {@code parentValue}. */
    @SuppressWarnings("unchecked")
    final Object inherited(Object parentValue) {
        return childValue((T) parentValue);
    }
}
