package brickless.concurrent;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import brickless.concurrent.locks.Waiting;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(30)
class ExecutorsTest {
    private final List<ExecutorService> pools = new ArrayList<>();
    private final CountDownLatch gate = new CountDownLatch(1);

    private <T extends ExecutorService> T closing(T pool) {
        pools.add(pool);
        return pool;
    }

    private ThreadPoolExecutor pool(int core, int max, int room) {
        return closing(new ThreadPoolExecutor(core, max, 1, TimeUnit.HOURS, new LinkedBlockingQueue<>(room)));
    }

    private void awaitGate() {
        boolean open = false;
        while (!open) {
            try {
                gate.await();
                open = true;
            } catch (InterruptedException e) {
                open = false;
            }
        }
    }

    @AfterEach
    void everyPoolTerminates() throws InterruptedException {
        gate.countDown();
        for (ExecutorService pool : pools) {
            pool.shutdownNow();
            assertThat(pool.awaitTermination(20, TimeUnit.SECONDS)).isTrue();
        }
    }

    @Test
    void taskIsPendingThenDoneOrFailedOrCancelled() throws Exception {
        FutureTask<Integer> good = new FutureTask<>(() -> 42);
        assertThat(good.isDone()).isFalse();
        assertThatThrownBy(() -> good.get(1, TimeUnit.MILLISECONDS)).isInstanceOf(TimeoutException.class);
        good.run();
        assertThat(good.get()).isEqualTo(42);
        assertThat(good.cancel(true)).isFalse();
        FutureTask<Integer> bad = new FutureTask<>(() -> {
            throw new IllegalStateException("bad");
        });
        bad.run();
        assertThatThrownBy(bad::get).isInstanceOf(ExecutionException.class)
                .hasCauseInstanceOf(IllegalStateException.class);
        FutureTask<Integer> cancelled = new FutureTask<>(() -> 1);
        Waiting getter = Waiting.in(cancelled::get);
        assertThat(cancelled.cancel(false)).isTrue();
        assertThat(getter.outcome()).isInstanceOf(CancellationException.class);
        cancelled.run();
        assertThat(cancelled.isCancelled()).isTrue();
    }

    @Test
    void cancellingInterruptsTheRunnerOnlyIfAsked() throws InterruptedException {
        FutureTask<Boolean> task = new FutureTask<>(() -> gate.await(1, TimeUnit.HOURS));
        Waiting runner = Waiting.in(task::run);
        assertThat(task.cancel(true)).isTrue();
        runner.ends();
        FutureTask<Void> left = new FutureTask<>(this::awaitGate, null);
        Waiting alone = Waiting.in(left::run);
        left.cancel(false);
        assertThat(alone.thread().isInterrupted()).isFalse();
        gate.countDown();
        alone.ends();
    }

    @Test
    void threadsAreNamedByPoolAndNumber() throws Exception {
        ExecutorService first = closing(Executors.newFixedThreadPool(2));
        ExecutorService second = closing(Executors.newSingleThreadExecutor());
        Callable<String> name = () -> Thread.currentThread().getName();
        String[] a = first.submit(name).get().split("-");
        String[] b = first.submit(name).get().split("-");
        String[] c = second.submit(name).get().split("-");
        assertThat(a).containsExactly("pool", a[1], "thread", "1");
        assertThat(b).containsExactly("pool", a[1], "thread", "2");
        assertThat(c).containsExactly("pool", String.valueOf(Integer.parseInt(a[1]) + 1), "thread", "1");
        assertThat(second).isNotInstanceOf(ThreadPoolExecutor.class);
    }

    @Test
    void poolFillsCoreThenQueueThenMaximumThenRejects() {
        ThreadPoolExecutor pool = pool(1, 2, 1);
        pool.execute(this::awaitGate);
        assertThat(pool.getPoolSize()).isEqualTo(1);
        pool.execute(this::awaitGate);
        assertThat(pool.getQueue()).hasSize(1);
        pool.execute(this::awaitGate);
        assertThat(pool.getPoolSize()).isEqualTo(2);
        assertThatThrownBy(() -> pool.execute(this::awaitGate)).isInstanceOf(RejectedExecutionException.class);
        assertThat(pool.getLargestPoolSize()).isEqualTo(2);
    }

    @Test
    void policiesDecideAboutRejectedTasks() {
        ThreadPoolExecutor pool = pool(1, 1, 1);
        List<String> ran = Collections.synchronizedList(new ArrayList<>());
        pool.execute(this::awaitGate);
        pool.execute(() -> ran.add("oldest"));
        pool.setRejectedExecutionHandler(new ThreadPoolExecutor.DiscardPolicy());
        pool.execute(() -> ran.add("discarded"));
        pool.setRejectedExecutionHandler(new ThreadPoolExecutor.CallerRunsPolicy());
        pool.execute(() -> ran.add("caller"));
        assertThat(ran).containsExactly("caller");
        pool.setRejectedExecutionHandler(new ThreadPoolExecutor.DiscardOldestPolicy());
        Runnable newest = () -> ran.add("newest");
        pool.execute(newest);
        assertThat(pool.getQueue()).containsExactly(newest);
        assertThat(pool.remove(newest)).isTrue();
    }

    @Test
    void shutdownRunsWhatIsQueuedAndShutdownNowDoesNot() throws InterruptedException {
        ThreadPoolExecutor gentle = pool(1, 1, 5);
        AtomicInteger ran = new AtomicInteger();
        gentle.execute(this::awaitGate);
        gentle.execute(ran::incrementAndGet);
        gentle.shutdown();
        assertThat(gentle.isTerminating()).isTrue();
        assertThat(gentle.awaitTermination(1, TimeUnit.MILLISECONDS)).isFalse();
        assertThatThrownBy(() -> gentle.execute(ran::incrementAndGet)).isInstanceOf(RejectedExecutionException.class);
        ThreadPoolExecutor abrupt = pool(1, 1, 5);
        CountDownLatch interrupted = new CountDownLatch(1);
        CountDownLatch started = new CountDownLatch(1);
        abrupt.execute(() -> {
            started.countDown();
            try {
                new CountDownLatch(1).await();
            } catch (InterruptedException e) {
                interrupted.countDown();
            }
        });
        Runnable waiting = () -> ran.addAndGet(100);
        abrupt.execute(waiting);
        started.await();
        assertThat(abrupt.shutdownNow()).containsExactly(waiting);
        interrupted.await();
        gate.countDown();
        assertThat(gentle.awaitTermination(20, TimeUnit.SECONDS)).isTrue();
        assertThat(abrupt.awaitTermination(20, TimeUnit.SECONDS)).isTrue();
        assertThat(ran).hasValue(1);
        assertThat(gentle.toString()).contains("[Terminated, pool size = 0", "completed tasks = 2]");
    }

    @Test
    void hooksSurroundEveryTaskAndTerminationIsTold() throws InterruptedException {
        List<String> events = Collections.synchronizedList(new ArrayList<>());
        ThreadPoolExecutor pool =
                closing(new ThreadPoolExecutor(1, 1, 0, TimeUnit.SECONDS, new LinkedBlockingQueue<>()) {
            @Override
            protected void beforeExecute(Thread t, Runnable r) {
                events.add("before");
            }

            @Override
            protected void afterExecute(Runnable r, Throwable t) {
                events.add("after " + t);
            }

            @Override
            protected void terminated() {
                events.add("terminated");
            }
        });
        pool.execute(() -> events.add("run"));
        pool.shutdown();
        pool.awaitTermination(20, TimeUnit.SECONDS);
        assertThat(events).containsExactly("before", "run", "after null", "terminated");
    }

    @Test
    void workerThatDiesIsReplaced() throws Exception {
        List<Thread> threads = Collections.synchronizedList(new ArrayList<>());
        CountDownLatch died = new CountDownLatch(1);
        ThreadPoolExecutor pool =
                closing(new ThreadPoolExecutor(1, 1, 0, TimeUnit.SECONDS, new LinkedBlockingQueue<>(), work -> {
            Thread thread = new Thread(work);
            thread.setUncaughtExceptionHandler((t, e) -> died.countDown());
            threads.add(thread);
            return thread;
        }));
        pool.execute(() -> {
            throw new IllegalStateException("expected by the test");
        });
        died.await();
        assertThat(pool.submit(() -> Thread.currentThread()).get()).isSameAs(threads.get(1));
        assertThat(pool.getPoolSize()).isEqualTo(1);
    }

    @Test
    void idleThreadsAboveTheCoreEndAfterTheKeepAliveTime() throws Exception {
        ThreadPoolExecutor pool =
                closing(new ThreadPoolExecutor(0, 5, 1, TimeUnit.MILLISECONDS, new SynchronousQueue<>()));
        Thread worker = pool.submit(() -> Thread.currentThread()).get();
        worker.join(20_000);
        assertThat(worker.isAlive()).isFalse();
        assertThat(pool.getPoolSize()).isZero();
        assertThat(pool.getCompletedTaskCount()).isEqualTo(1);
    }

    @Test
    void sizesCanBeChangedWhileThePoolRuns() throws Exception {
        ThreadPoolExecutor pool = pool(2, 2, 5);
        assertThat(pool.prestartAllCoreThreads()).isEqualTo(2);
        pool.setCorePoolSize(1);
        pool.setMaximumPoolSize(1);
        assertThat(pool.submit(() -> 1).get()).isEqualTo(1);
        assertThatThrownBy(() -> pool.setCorePoolSize(2)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> pool(2, 1, 1)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void invokeAllWaitsForAllAndInvokeAnyForTheFirstSuccess() throws Exception {
        ExecutorService pool = pool(2, 2, 10);
        Callable<Integer> bad = () -> {
            throw new IllegalStateException();
        };
        List<Future<Integer>> all = pool.invokeAll(List.of(() -> 1, bad, () -> 3));
        assertThat(all).allMatch(Future::isDone);
        assertThat(all.get(2).get()).isEqualTo(3);
        assertThat(pool.invokeAny(List.of(bad, () -> 2))).isEqualTo(2);
        assertThatThrownBy(() -> pool.invokeAny(List.of(bad, bad))).isInstanceOf(ExecutionException.class);
        Callable<Integer> slow = () -> {
            gate.await();
            return 4;
        };
        assertThatThrownBy(() -> pool.invokeAny(List.of(slow), 1, TimeUnit.MILLISECONDS))
                .isInstanceOf(TimeoutException.class);
        assertThat(pool.invokeAll(List.of(slow), 1, TimeUnit.MILLISECONDS)).allMatch(Future::isCancelled);
    }

    @Test
    void completionServiceReturnsTasksAsTheyComplete() throws Exception {
        ExecutorCompletionService<String> service = new ExecutorCompletionService<>(pool(2, 2, 5));
        service.submit(() -> {
            gate.await();
            return "slow";
        });
        service.submit(() -> "fast");
        assertThat(service.take().get()).isEqualTo("fast");
        assertThat(service.poll()).isNull();
        gate.countDown();
        assertThat(service.take().get()).isEqualTo("slow");
    }

    @Test
    void scheduledTasksRunByDueTimeAndPeriodically() throws Exception {
        ScheduledThreadPoolExecutor scheduler = closing(new ScheduledThreadPoolExecutor(1));
        List<String> order = Collections.synchronizedList(new ArrayList<>());
        scheduler.execute(this::awaitGate);
        ScheduledFuture<?> second = scheduler.schedule(() -> order.add("second"), 2, TimeUnit.MILLISECONDS);
        scheduler.schedule(() -> order.add("first"), 1, TimeUnit.NANOSECONDS);
        gate.countDown();
        second.get();
        assertThat(order).containsExactly("first", "second");
        CountDownLatch ticks = new CountDownLatch(3);
        ScheduledFuture<?> rate = scheduler.scheduleAtFixedRate(ticks::countDown, 0, 1, TimeUnit.MILLISECONDS);
        ticks.await();
        assertThat(rate.cancel(false)).isTrue();
        CountDownLatch more = new CountDownLatch(3);
        ScheduledFuture<?> delay = scheduler.scheduleWithFixedDelay(more::countDown, 0, 1, TimeUnit.MILLISECONDS);
        more.await();
        assertThat(delay.isDone()).isFalse();
        assertThatThrownBy(() -> scheduler.scheduleAtFixedRate(more::countDown, 0, 0, TimeUnit.SECONDS))
                .isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void periodicTaskThatThrowsIsNotRunAgain() {
        ScheduledExecutorService scheduler = closing(Executors.newSingleThreadScheduledExecutor());
        AtomicInteger runs = new AtomicInteger();
        ScheduledFuture<?> failing = scheduler.scheduleAtFixedRate(() -> {
            runs.incrementAndGet();
            throw new IllegalStateException();
        }, 0, 1, TimeUnit.NANOSECONDS);
        assertThatThrownBy(failing::get).isInstanceOf(ExecutionException.class);
        assertThat(runs).hasValue(1);
    }

    @Test
    void shutdownKeepsDelayedTasksAndDropsPeriodicOnesUnlessToldOtherwise() throws InterruptedException {
        ScheduledThreadPoolExecutor scheduler = closing(new ScheduledThreadPoolExecutor(1));
        AtomicInteger runs = new AtomicInteger();
        scheduler.schedule(runs::incrementAndGet, 2, TimeUnit.MILLISECONDS);
        ScheduledFuture<?> periodic = scheduler.scheduleAtFixedRate(() -> runs.addAndGet(100), 1, 1, TimeUnit.HOURS);
        scheduler.shutdown();
        assertThat(periodic.isCancelled()).isTrue();
        assertThat(scheduler.awaitTermination(20, TimeUnit.SECONDS)).isTrue();
        assertThat(runs).hasValue(1);
        ScheduledThreadPoolExecutor strict = closing(new ScheduledThreadPoolExecutor(1));
        strict.setExecuteExistingDelayedTasksAfterShutdownPolicy(false);
        ScheduledFuture<?> delayed = strict.schedule(runs::incrementAndGet, 1, TimeUnit.HOURS);
        strict.shutdown();
        assertThat(delayed.isCancelled()).isTrue();
        assertThat(strict.awaitTermination(20, TimeUnit.SECONDS)).isTrue();
        assertThatThrownBy(() -> strict.schedule(runs::incrementAndGet, 0, TimeUnit.SECONDS))
                .isInstanceOf(RejectedExecutionException.class);
    }

    @Test
    void cancelledTaskLeavesTheQueueIfToldSo() {
        ScheduledThreadPoolExecutor scheduler = closing(new ScheduledThreadPoolExecutor(1));
        ScheduledFuture<?> kept = scheduler.schedule(() -> 1, 1, TimeUnit.HOURS);
        kept.cancel(false);
        assertThat(scheduler.getQueue()).hasSize(1);
        scheduler.purge();
        assertThat(scheduler.getQueue()).isEmpty();
        scheduler.setRemoveOnCancelPolicy(true);
        scheduler.schedule(() -> 1, 1, TimeUnit.HOURS).cancel(false);
        assertThat(scheduler.getQueue()).isEmpty();
    }

    @Test
    void forkJoinTasksRunInDaemonWorkers() throws Exception {
        ForkJoinPool pool = closing(new ForkJoinPool(1));
        Thread worker = pool.submit(() -> Thread.currentThread()).get();
        assertThat(worker).isInstanceOf(ForkJoinWorkerThread.class).matches(Thread::isDaemon);
        assertThat(worker.getName()).startsWith("ForkJoinPool-").endsWith("-worker-1");
        ForkJoinTask<?> bad = pool.submit((Runnable) () -> {
            throw new IllegalStateException("bad");
        });
        assertThatThrownBy(bad::join).hasMessage("bad");
        assertThatThrownBy(bad::get).isInstanceOf(ExecutionException.class);
        assertThat(bad.isCompletedAbnormally()).isTrue();
        assertThat(pool.awaitQuiescence(20, TimeUnit.SECONDS)).isTrue();
        ForkJoinPool.commonPool().shutdownNow();
        assertThat(ForkJoinPool.commonPool().submit(() -> 5).join()).isEqualTo(5);
    }

    @Test
    void workerThatJoinsRunsWhatNobodyHasBegun() {
        ForkJoinPool pool = closing(new ForkJoinPool(1));
        RecursiveTask<Integer> sum = new RecursiveTask<>() {
            @Override
            protected Integer compute() {
                ForkJoinTask<Integer> left = ForkJoinTask.adapt(() -> 1).fork();
                ForkJoinTask<Integer> right = ForkJoinTask.adapt(() -> 2);
                ForkJoinTask.invokeAll(right, ForkJoinTask.adapt(() -> { }));
                return left.join() + right.join();
            }
        };
        assertThat(pool.invoke(sum)).isEqualTo(3);
    }
}
