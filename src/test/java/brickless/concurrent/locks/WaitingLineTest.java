package brickless.concurrent.locks;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(30)
class WaitingLineTest {
    /** Guarded by the line. */
    private boolean free;

    private boolean take() {
        boolean taken = free;
        free = false;
        return taken;
    }

    private void give(WaitingLine line) {
        synchronized (line) {
            free = true;
            line.changed();
        }
    }

    private static void awaitTries(WaitingLine line, int[] tries, int wanted) throws InterruptedException {
        synchronized (line) {
            while (tries[0] < wanted) {
                line.wait();
            }
        }
    }

    @Test
    void fairLineLetsNobodyOvertake() throws InterruptedException {
        WaitingLine line = new WaitingLine(true);
        Waiting first = Waiting.in(() -> line.pass(this::take, Deadline.NEVER));
        synchronized (line) {
            free = true;
            assertThat(line.pass(this::take, Deadline.after(0))).isFalse();
            line.changed();
        }
        first.ends();
    }

    @Test
    void threadWokenInVainIsOvertakenNoMore() throws InterruptedException {
        WaitingLine line = new WaitingLine(false);
        int[] tries = new int[1];
        Waiting first = Waiting.in(() -> line.pass(() -> {
            tries[0]++;
            line.notifyAll();
            return take();
        }, Deadline.NEVER));
        synchronized (line) {
            free = true;
            assertThat(line.pass(this::take, Deadline.after(0))).as("overtakes").isTrue();
            line.changed();
        }
        // Once when it came, once when it was in the line, once when it was woken.
        awaitTries(line, tries, 3);
        synchronized (line) {
            free = true;
            assertThat(line.pass(this::take, Deadline.after(0))).as("overtakes again").isFalse();
            line.changed();
        }
        first.ends();
    }

    @Test
    void interruptedThreadLeavesTheLine() throws InterruptedException {
        WaitingLine line = new WaitingLine(true);
        Waiting first = Waiting.in(() -> line.pass(this::take, Deadline.NEVER));
        Waiting second = Waiting.in(() -> line.pass(this::take, Deadline.NEVER));
        assertThat(line.threads()).containsExactly(first.thread(), second.thread());
        assertThat(first.interrupted().outcome()).isInstanceOf(InterruptedException.class);
        give(line);
        second.ends();
        assertThat(line.length()).isZero();
    }

    @Test
    void failureOfTheAttemptLeavesTheLine() {
        WaitingLine line = new WaitingLine(false);
        assertThatThrownBy(() -> line.passUninterruptibly(() -> {
            throw new IllegalStateException("attempt");
        })).hasMessage("attempt");
        assertThat(line.length()).isZero();
    }

    @Test
    void deadlinesPassAndFarOnesNever() throws InterruptedException {
        assertThat(Deadline.after(0).passed()).isTrue();
        assertThat(Deadline.after(-1).await(this)).isFalse();
        assertThat(Deadline.after(Long.MAX_VALUE, TimeUnit.DAYS)).isSameAs(Deadline.NEVER);
        assertThat(Deadline.NEVER.nanosLeft()).isEqualTo(Long.MAX_VALUE);
        assertThat(Deadline.after(1, TimeUnit.DAYS).orAfter(0).passed()).isTrue();
        Deadline soon = Deadline.after(1, TimeUnit.DAYS);
        assertThat(soon.orAfter(Long.MAX_VALUE)).isSameAs(soon);
    }
}
