package brickless.concurrent;

/** {@code java.util.concurrent.RecursiveTask}. */
public abstract class RecursiveTask<V> extends ForkJoinTask<V> {
    private V result;

    /** Creates the task. */
    public RecursiveTask() {
    }

    /** Computes the result. */
    protected abstract V compute();

    @Override
    public final V getRawResult() {
        return result;
    }

    @Override
    protected final void setRawResult(V value) {
        result = value;
    }

    @Override
    protected final boolean exec() {
        result = compute();
        return true;
    }
}
