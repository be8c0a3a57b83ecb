package brickless.concurrent;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import brickless.concurrent.locks.Waiting;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(30)
class CompletableFutureTest {
    private final CompletableFuture<Integer> future = new CompletableFuture<>();

    @Test
    void getAndJoinWaitUntilTheFutureIsComplete() throws InterruptedException {
        Waiting get = Waiting.in(() -> assertThat(future.get()).isEqualTo(1));
        Waiting timed = Waiting.in(() -> assertThat(future.get(1, TimeUnit.HOURS)).isEqualTo(1));
        Waiting join = Waiting.in(() -> assertThat(future.join()).isEqualTo(1));
        future.complete(1);
        get.ends();
        timed.ends();
        join.ends();
    }

    @Test
    void interruptEndsGetButNotJoin() throws InterruptedException {
        Waiting get = Waiting.in(future::get);
        assertThat(get.interrupted().outcome()).isInstanceOf(InterruptedException.class);
        boolean[] flag = new boolean[1];
        Waiting join = Waiting.in(() -> {
            future.join();
            flag[0] = Thread.currentThread().isInterrupted();
        });
        join.interrupted();
        future.complete(1);
        join.ends();
        assertThat(flag[0]).isTrue();
    }

    @Test
    void failuresAreWrappedAsDocumented() {
        IllegalStateException bad = new IllegalStateException("bad");
        future.completeExceptionally(bad);
        assertThatThrownBy(future::get).isInstanceOf(ExecutionException.class).hasCause(bad);
        assertThatThrownBy(future::join).isInstanceOf(CompletionException.class).hasCause(bad);
        CompletableFuture<Integer> dependent = (CompletableFuture<Integer>) future.thenApply(x -> x + 1);
        assertThatThrownBy(dependent::get).isInstanceOf(ExecutionException.class).hasCause(bad);
        assertThatThrownBy(CompletableFuture.allOf(future, dependent)::get).isInstanceOf(ExecutionException.class)
                .hasCause(bad);
        CompletableFuture<Integer> cancelled = new CompletableFuture<>();
        cancelled.cancel(true);
        assertThatThrownBy(cancelled::get).isInstanceOf(CancellationException.class);
    }

    @Test
    void everyStageIsOfThisClassSoThatItsWaitingIsVirtual() {
        IllegalStateException bad = new IllegalStateException();
        CompletionStage<?>[] stages = {
            future.thenApply(x -> x), future.thenAcceptAsync(x -> { }), future.handle((x, e) -> x), future.copy(),
            future.thenCompose(x -> new CompletableFuture<>()), future.thenCombine(future, Integer::sum),
            future.minimalCompletionStage().toCompletableFuture(), CompletableFuture.completedStage(1),
            CompletableFuture.supplyAsync(() -> 1), CompletableFuture.runAsync(() -> { }),
            CompletableFuture.allOf(future), CompletableFuture.anyOf(future),
            CompletableFuture.failedFuture(bad).exceptionally(e -> 1),
            CompletableFuture.failedStage(bad).whenComplete((x, e) -> { })};
        assertThat(stages).allMatch(stage -> stage instanceof CompletableFuture);
    }

    @Test
    void asynchronousStagesRunInAThreadOfTheirOwn() {
        Thread runner = CompletableFuture.supplyAsync(Thread::currentThread).join();
        assertThat(runner).isNotSameAs(Thread.currentThread()).matches(thread -> !thread.isDaemon());
        AtomicReference<Runnable> handed = new AtomicReference<>();
        java.util.concurrent.CompletableFuture<Integer> stage = CompletableFuture.supplyAsync(() -> 3, handed::set);
        assertThat(stage.isDone()).isFalse();
        handed.get().run();
        assertThat(stage.getNow(0)).isEqualTo(3);
    }

    @Test
    void timeOutsCompleteWhatIsNotComplete() {
        assertThatThrownBy(() -> future.get(1, TimeUnit.MILLISECONDS)).isInstanceOf(TimeoutException.class);
        assertThat(new CompletableFuture<Integer>().completeOnTimeout(5, 1, TimeUnit.MILLISECONDS).join()).isEqualTo(5);
        assertThatThrownBy(future.orTimeout(1, TimeUnit.MILLISECONDS)::get).hasCauseInstanceOf(TimeoutException.class);
        CompletableFuture<Integer> inTime = new CompletableFuture<>();
        inTime.completeOnTimeout(5, 1, TimeUnit.HOURS).complete(6);
        assertThat(inTime.join()).isEqualTo(6);
    }

    @Test
    void delayedExecutorRunsTasksLater() {
        assertThat(CompletableFuture.supplyAsync(() -> 9, CompletableFuture.delayedExecutor(1, TimeUnit.MILLISECONDS))
                .join()).isEqualTo(9);
    }

    @Test
    void anyOfTakesTheFirst() {
        CompletableFuture<Integer> other = new CompletableFuture<>();
        java.util.concurrent.CompletableFuture<Object> any = CompletableFuture.anyOf(future, other);
        other.complete(2);
        assertThat(any.join()).isEqualTo(2);
        assertThat(CompletableFuture.allOf().isDone()).isTrue();
    }
}
