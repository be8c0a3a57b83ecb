package brickless.concurrent;

import java.util.concurrent.Callable;
import java.util.concurrent.RunnableFuture;

/** A callable as a {@link ForkJoinTask}. */
final class AdaptedTask<T> extends ForkJoinTask<T> implements RunnableFuture<T> {
    private final Callable<? extends T> callable;
    private T result;

    AdaptedTask(Callable<? extends T> callable) {
        if (callable == null) {
            throw new NullPointerException();
        }
        this.callable = callable;
    }

    @Override
    public T getRawResult() {
        return result;
    }

    @Override
    protected void setRawResult(T value) {
        result = value;
    }

    @Override
    protected boolean exec() {
        try {
            result = callable.call();
            return true;
        } catch (RuntimeException e) {
            throw e;
        } catch (Exception e) {
            throw new RuntimeException(e);
        }
    }

    @Override
    public void run() {
        invoke();
    }

    @Override
    public String toString() {
        return super.toString() + "[Wrapped task = " + callable + "]";
    }
}
