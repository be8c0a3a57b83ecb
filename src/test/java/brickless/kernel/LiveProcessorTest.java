package brickless.kernel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(20)
class LiveProcessorTest {
    private static final long STEP = 1_000_000;

    @Test
    void stepsComeInOrderAndNoneIsLeftOut() throws Exception {
        List<Long> steps = new ArrayList<>();
        CountDownLatch enough = new CountDownLatch(20);
        try (LiveProcessor processor = new LiveProcessor(STEP, time -> {
            steps.add(time);
            enough.countDown();
        })) {
            processor.start();
            enough.await();
            List<Long> seen = processor.exclusively(() -> List.copyOf(steps));
            assertThat(seen).isEqualTo(LongStream.rangeClosed(1, seen.size()).mapToObj(i -> i * STEP).toList());
        }
    }

    @Test
    void aSignalRaisedByAStepWakesAThread() {
        LiveProcessor[] processor = new LiveProcessor[1];
        Processor.Signal[] signal = new Processor.Signal[1];
        processor[0] = new LiveProcessor(STEP, time -> {
            if (time >= 5 * STEP) {
                signal[0].raise();
            }
        });
        signal[0] = processor[0].newSignal();
        processor[0].start();
        assertThat(signal[0].await(0)).isTrue();
        assertThat(processor[0].nowNanos()).isGreaterThanOrEqualTo(5 * STEP);
        processor[0].close();
    }

    @Test
    void waitingGivesTheLockUpAndTakesItBack() {
        LiveProcessor[] processor = new LiveProcessor[1];
        Processor.Signal[] signal = new Processor.Signal[1];
        processor[0] = new LiveProcessor(STEP, time -> signal[0].raise());
        signal[0] = processor[0].newSignal();
        processor[0].start();
        boolean raised = processor[0].exclusively(() -> signal[0].await(0));
        assertThat(raised).isTrue();
        processor[0].close();
    }

    @Test
    void aTimeoutEndsAWait() {
        LiveProcessor processor = new LiveProcessor(STEP, time -> { });
        assertThat(processor.newSignal().await(1)).isFalse();
    }

    @Test
    void anInterruptEndsOnlyAnInterruptibleWaitAndIsKeptByTheOther() throws Exception {
        LiveProcessor processor = new LiveProcessor(STEP, time -> { });
        Processor.Signal signal = processor.newSignal();
        Thread.currentThread().interrupt();
        assertThatThrownBy(() -> signal.awaitInterruptibly(0)).isInstanceOf(InterruptedException.class);
        Thread.currentThread().interrupt();
        assertThat(signal.await(1_000)).isFalse();
        assertThat(Thread.interrupted()).isTrue();
    }

    @Test
    void chargesTakeTimeOnceTheyAddUpToAMillisecond() {
        LiveProcessor processor = new LiveProcessor(STEP, time -> { });
        processor.start();
        for (int i = 0; i < 10; i++) {
            processor.charge(500_000);
        }
        assertThat(processor.nowNanos()).isGreaterThanOrEqualTo(4 * STEP);
        processor.close();
    }
}
