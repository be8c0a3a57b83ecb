package brickless.concurrent.util;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Date;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.SynchronousQueue;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(30)
class TimerTest {
    private final Timer timer = new Timer(true);
    private final SynchronousQueue<String> runs = new SynchronousQueue<>();

    /** Hands its name, and what it is told to do, to the test. */
    private final class Named extends TimerTask {
        private final String name;

        Named(String name) {
            this.name = name;
        }

        @Override
        public void run() {
            try {
                runs.put(name);
            } catch (InterruptedException e) {
                throw new AssertionError(e);
            }
        }
    }

    private static TimerTask task(Runnable action) {
        return new TimerTask() {
            @Override
            public void run() {
                action.run();
            }
        };
    }

    @AfterEach
    void cancelTimer() {
        timer.cancel();
    }

    @Test
    void tasksRunByDueTimeAndThoseDueTogetherInOrderOfScheduling() throws InterruptedException {
        timer.schedule(new Named("gate"), new Date(0));
        timer.schedule(new Named("third"), new Date(2000));
        timer.schedule(new Named("first"), new Date(1000));
        timer.schedule(new Named("fourth"), new Date(2000));
        timer.schedule(new Named("second"), new Date(1000));
        assertThat(runs.take()).isEqualTo("gate");
        assertThat(runs.take()).isEqualTo("first");
        assertThat(runs.take()).isEqualTo("second");
        assertThat(runs.take()).isEqualTo("third");
        assertThat(runs.take()).isEqualTo("fourth");
    }

    @Test
    void fixedRateCatchesUpAndTellsWhenEachRunWasDue() throws InterruptedException {
        long first = System.currentTimeMillis() - 25;
        long[] due = new long[3];
        CountDownLatch done = new CountDownLatch(3);
        timer.scheduleAtFixedRate(new TimerTask() {
            @Override
            public void run() {
                int run = 3 - (int) done.getCount();
                due[Math.min(run, 2)] = scheduledExecutionTime();
                if (run == 2) {
                    cancel();
                }
                done.countDown();
            }
        }, new Date(first), 10);
        done.await();
        assertThat(due).containsExactly(first, first + 10, first + 20);
    }

    @Test
    void fixedDelayDoesNotCatchUp() throws InterruptedException {
        CountDownLatch done = new CountDownLatch(2);
        long[] due = new long[2];
        timer.schedule(new TimerTask() {
            @Override
            public void run() {
                due[2 - (int) Math.max(done.getCount(), 1)] = scheduledExecutionTime();
                done.countDown();
            }
        }, new Date(0), 1);
        done.await();
        assertThat(due[0]).isZero();
        assertThat(due[1]).isGreaterThan(1_000_000_000_000L);
    }

    @Test
    void cancelTellsWhetherItPreventedARun() throws InterruptedException {
        TimerTask fresh = task(() -> { });
        assertThat(fresh.cancel()).isFalse();
        timer.schedule(task(() -> { }), 1_800_000);
        TimerTask waiting = task(() -> { });
        timer.schedule(waiting, 3_600_000);
        assertThat(waiting.cancel()).isTrue();
        assertThat(waiting.cancel()).isFalse();
        assertThat(timer.purge()).isEqualTo(1);
        Named once = new Named("once");
        timer.schedule(once, 0);
        assertThat(runs.take()).isEqualTo("once");
        assertThat(once.cancel()).isFalse();
        assertThatThrownBy(() -> timer.schedule(once, 0)).isInstanceOf(IllegalStateException.class);
        assertThatThrownBy(() -> timer.schedule(fresh, 0)).isInstanceOf(IllegalStateException.class);
    }

    @Test
    void badArgumentsAreRefused() {
        TimerTask task = task(() -> { });
        assertThatThrownBy(() -> timer.schedule(task, -1)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> timer.schedule(task, 0, 0)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> timer.schedule(task, new Date(-1))).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> timer.schedule(task, Long.MAX_VALUE)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> timer.schedule(null, 0)).isInstanceOf(NullPointerException.class);
        assertThatThrownBy(() -> new Timer((String) null)).isInstanceOf(NullPointerException.class);
    }

    @Test
    void taskThatThrowsEndsItsTimer() throws InterruptedException {
        CountDownLatch died = new CountDownLatch(1);
        Thread[] thread = new Thread[1];
        timer.schedule(task(() -> {
            thread[0] = Thread.currentThread();
            thread[0].setUncaughtExceptionHandler((t, e) -> died.countDown());
            throw new IllegalStateException("expected by the test");
        }), 0);
        died.await();
        thread[0].join();
        assertThat(thread[0].getName()).startsWith("Timer-");
        assertThat(thread[0].isDaemon()).isTrue();
        assertThatThrownBy(() -> timer.schedule(task(() -> { }), 0)).isInstanceOf(IllegalStateException.class);
    }
}
