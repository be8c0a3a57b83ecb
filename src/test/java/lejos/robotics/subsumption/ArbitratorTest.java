package lejos.robotics.subsumption;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(value = 10, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class ArbitratorTest {
    private final Recorded low = new Recorded();
    private final Recorded middle = new Recorded();
    private final Recorded high = new Recorded();
    private final Behavior[] all = {low, middle, high};

    @Test
    void highestWillingBehaviourActsFirst() {
        low.wants = true;
        high.wants = true;
        AtomicReference<String> first = new AtomicReference<>();
        Arbitrator arbitrator = new Arbitrator(all);
        low.act = () -> end(first, "low", arbitrator);
        high.act = () -> end(first, "high", arbitrator);
        arbitrator.go();
        assertThat(first.get()).isEqualTo("high");
    }

    @Test
    void behavioursBelowAWillingOneAreNotAsked() {
        high.wants = true;
        middle.wants = true;
        Arbitrator arbitrator = new Arbitrator(all);
        high.act = arbitrator::stop;
        arbitrator.go();
        assertThat(middle.asked.get() + low.asked.get()).isZero();
    }

    @Test
    void onlyBehavioursAboveTheActiveOneAreAskedDuringItsAction() {
        middle.wants = true;
        Arbitrator arbitrator = new Arbitrator(all);
        middle.act = () -> {
            int askedBefore = middle.asked.get() + low.asked.get();
            high.awaitAskedAgain(5);
            assertThat(middle.asked.get() + low.asked.get()).isEqualTo(askedBefore);
            arbitrator.stop();
        };
        arbitrator.go();
        assertThat(middle.acted.get()).isEqualTo(1);
    }

    @Test
    void suppressIsRepeatedUntilTheActionReturns() {
        low.wants = true;
        Arbitrator arbitrator = new Arbitrator(all);
        low.act = () -> {
            high.wants = true;
            low.awaitSuppressed(4);
        };
        high.act = arbitrator::stop;
        arbitrator.go();
        assertThat(low.suppressed.get()).isGreaterThanOrEqualTo(4);
        assertThat(high.suppressed.get() + middle.suppressed.get()).isZero();
        assertThat(high.acted.get()).isEqualTo(1);
    }

    @Test
    void actionOfHigherBehaviourWaitsForTheLowerToReturn() {
        low.wants = true;
        Arbitrator arbitrator = new Arbitrator(all);
        AtomicInteger highActionsSeenInside = new AtomicInteger(-1);
        low.act = () -> {
            high.wants = true;
            low.awaitSuppressed(20);
            highActionsSeenInside.set(high.acted.get());
        };
        high.act = arbitrator::stop;
        arbitrator.go();
        assertThat(highActionsSeenInside.get()).isZero();
    }

    @Test
    void behaviourThatStillWantsToDriveActsAgain() {
        low.wants = true;
        Arbitrator arbitrator = new Arbitrator(all, true);
        low.act = () -> low.wants = low.acted.get() < 50;
        arbitrator.go();
        assertThat(low.acted.get()).isEqualTo(50);
    }

    @Test
    void oneWishGivesOneActionHoweverShort() {
        for (int trial = 0; trial < 100; trial++) {
            Recorded once = new Recorded();
            once.wants = true;
            once.act = () -> once.wants = false;
            new Arbitrator(new Behavior[] {once}, true).go();
            assertThat(once.acted.get()).as("trial " + trial).isEqualTo(1);
        }
    }

    @Test
    void wishThatPassesBeforeItsTurnOnlySuppresses() {
        low.wants = true;
        Arbitrator arbitrator = new Arbitrator(all);
        low.act = () -> {
            if (low.acted.get() == 10) {
                arbitrator.stop();
                return;
            }
            int before = low.suppressed.get();
            high.wants = true;
            low.awaitSuppressed(before + 1);
            high.wants = false;
        };
        arbitrator.go();
        assertThat(high.acted.get()).isZero();
        assertThat(low.acted.get()).isEqualTo(10);
        assertThat(low.suppressed.get()).isGreaterThanOrEqualTo(9);
    }

    @Test
    void permanentlyWillingHigherBehaviourStarvesTheLower() {
        low.wants = true;
        high.wants = true;
        Arbitrator arbitrator = new Arbitrator(all);
        high.act = () -> {
            if (high.acted.get() == 100) {
                arbitrator.stop();
            }
        };
        arbitrator.go();
        assertThat(low.acted.get()).isZero();
    }

    @Test
    void runningActionIsNotStoppedWhenItsOwnWishEnds() {
        low.wants = true;
        Arbitrator arbitrator = new Arbitrator(all);
        low.act = () -> {
            low.wants = false;
            high.awaitAskedAgain(5);
            arbitrator.stop();
        };
        arbitrator.go();
        assertThat(low.suppressed.get()).isZero();
    }

    @Test
    void goWaitsForTheFirstWishEvenIfToldToReturnWhenInactive() {
        Arbitrator arbitrator = new Arbitrator(all, true);
        low.act = () -> low.wants = false;
        low.onAsked = () -> low.wants = low.asked.get() == 5;
        arbitrator.go();
        assertThat(low.acted.get()).isEqualTo(1);
    }

    @Test
    void goReturnsWhenNobodyWantsToDriveAnyMoreAndNobodyIsAskedAfterwards() {
        low.wants = true;
        low.act = () -> low.wants = false;
        Arbitrator arbitrator = new Arbitrator(all, true);
        arbitrator.go();
        int asked = high.asked.get();
        Recorded other = new Recorded();
        other.wants = true;
        Arbitrator clock = new Arbitrator(new Behavior[] {other, new Recorded()});
        other.act = clock::stop;
        clock.go();
        assertThat(high.asked.get()).isEqualTo(asked);
    }

    @Test
    void goIdlesUntilSomebodyWantsToDriveAgain() {
        low.wants = true;
        Arbitrator arbitrator = new Arbitrator(all);
        low.act = () -> {
            if (low.acted.get() == 2) {
                arbitrator.stop();
            }
            low.wants = false;
            int now = low.asked.get();
            low.onAsked = () -> low.wants = low.asked.get() > now + 5;
        };
        arbitrator.go();
        assertThat(low.acted.get()).isEqualTo(2);
    }

    @Test
    void stopEndsGoWhenTheRunningActionReturns() {
        low.wants = true;
        high.wants = false;
        Arbitrator arbitrator = new Arbitrator(all);
        low.act = () -> {
            high.wants = true;
            low.awaitSuppressed(1);
            arbitrator.stop();
        };
        arbitrator.go();
        assertThat(low.acted.get()).isEqualTo(1);
        assertThat(high.acted.get()).isZero();
    }

    @Test
    void stopFromAnotherThreadEndsAnIdleGo() throws InterruptedException {
        Arbitrator arbitrator = new Arbitrator(all);
        Thread driver = new Thread(arbitrator::go);
        driver.start();
        low.awaitAskedAgain(2);
        arbitrator.stop();
        driver.join();
        assertThat(low.acted.get()).isZero();
    }

    @Test
    void clearingKeepRunningStopsToo() {
        low.wants = true;
        Arbitrator arbitrator = new Arbitrator(all);
        assertThat(arbitrator.keepRunning).isTrue();
        low.act = () -> arbitrator.keepRunning = false;
        arbitrator.go();
        assertThat(low.acted.get()).isEqualTo(1);
    }

    @Test
    void stopBeforeGoMakesGoReturnAtOnce() {
        low.wants = true;
        Arbitrator arbitrator = new Arbitrator(all);
        arbitrator.stop();
        arbitrator.go();
        assertThat(low.acted.get()).isZero();
    }

    @Test
    void emptyListEndsWhenStopped() throws InterruptedException {
        Arbitrator arbitrator = new Arbitrator(new Behavior[0], true);
        Thread driver = new Thread(arbitrator::go);
        driver.start();
        arbitrator.stop();
        driver.join();
        assertThat(arbitrator.keepRunning).isFalse();
    }

    @Test
    void secondGoIsRefused() {
        low.wants = true;
        Arbitrator arbitrator = new Arbitrator(all);
        low.act = arbitrator::stop;
        arbitrator.go();
        assertThatThrownBy(arbitrator::go).isInstanceOf(IllegalThreadStateException.class);
    }

    @Test
    void secondGoDoesNotDisturbTheFirst() {
        low.wants = true;
        Arbitrator arbitrator = new Arbitrator(all);
        low.act = () -> {
            if (low.acted.get() == 1) {
                assertThatThrownBy(arbitrator::go).isInstanceOf(IllegalThreadStateException.class);
            } else {
                arbitrator.stop();
            }
        };
        arbitrator.go();
        assertThat(low.acted.get()).isEqualTo(2);
    }

    @Test
    void nullListIsRefused() {
        assertThatThrownBy(() -> new Arbitrator(null)).isInstanceOf(NullPointerException.class);
    }

    @Test
    void nullBehaviourFailsInGo() {
        Arbitrator arbitrator = new Arbitrator(new Behavior[] {low, null});
        assertThatThrownBy(arbitrator::go).isInstanceOf(NullPointerException.class);
    }

    @Test
    void replacedElementTakesEffect() {
        Recorded replacement = new Recorded();
        Arbitrator arbitrator = new Arbitrator(all);
        low.wants = true;
        low.act = () -> {
            low.wants = false;
            replacement.wants = true;
            all[1] = replacement;
        };
        replacement.act = arbitrator::stop;
        arbitrator.go();
        assertThat(replacement.acted.get()).isEqualTo(1);
    }

    @Test
    void exceptionOfAnActionComesOutOfGo() {
        low.wants = true;
        low.act = () -> {
            throw new IllegalStateException("broken action");
        };
        assertThatThrownBy(new Arbitrator(all)::go).hasMessage("broken action");
    }

    @Test
    void exceptionOfTakeControlComesOutOfAnIdleGo() {
        low.onAsked = () -> {
            throw new IllegalStateException("broken wish");
        };
        assertThatThrownBy(new Arbitrator(all)::go).hasMessage("broken wish");
    }

    @Test
    void errorOfTakeControlComesOutOfGoWhenTheRunningActionReturnsAndIsReportedAtOnce() {
        low.wants = true;
        CountDownLatch reported = new CountDownLatch(1);
        high.onAsked = () -> {
            if (low.acted.get() > 0) {
                Thread.currentThread().setUncaughtExceptionHandler((thread, failure) -> reported.countDown());
                throw new StackOverflowError("deep wish");
            }
        };
        low.act = () -> await(reported);
        assertThatThrownBy(new Arbitrator(all)::go).isInstanceOf(StackOverflowError.class);
        assertThat(low.acted.get()).isEqualTo(1);
    }

    @Test
    void exceptionOfSuppressComesOutOfGoAndTheHigherActionDoesNotRun() {
        low.wants = true;
        CountDownLatch reported = new CountDownLatch(1);
        low.act = () -> {
            high.wants = true;
            await(reported);
        };
        low.onSuppressed = () -> {
            Thread.currentThread().setUncaughtExceptionHandler((thread, failure) -> reported.countDown());
            throw new IllegalStateException("broken suppress");
        };
        assertThatThrownBy(new Arbitrator(all)::go).hasMessage("broken suppress");
        assertThat(high.acted.get()).isZero();
    }

    @Test
    void interruptIsKeptForTheNextAction() {
        Arbitrator arbitrator = new Arbitrator(all);
        low.onAsked = () -> low.wants = low.asked.get() > 3;
        AtomicReference<Boolean> seen = new AtomicReference<>();
        low.act = () -> {
            seen.set(Thread.interrupted());
            arbitrator.stop();
        };
        Thread.currentThread().interrupt();
        arbitrator.go();
        assertThat(seen.get()).isTrue();
    }

    @Test
    void actionsRunOnTheCallersThreadAndTheRestOnOneDaemon() {
        low.wants = true;
        Arbitrator arbitrator = new Arbitrator(all);
        AtomicReference<Thread> asking = new AtomicReference<>();
        AtomicReference<Thread> suppressing = new AtomicReference<>();
        AtomicReference<Thread> acting = new AtomicReference<>();
        high.onAsked = () -> asking.set(Thread.currentThread());
        low.onSuppressed = () -> suppressing.set(Thread.currentThread());
        low.act = () -> {
            acting.set(Thread.currentThread());
            high.wants = true;
            low.awaitSuppressed(1);
            arbitrator.stop();
        };
        arbitrator.go();
        assertThat(acting.get()).isSameAs(Thread.currentThread());
        assertThat(asking.get()).isSameAs(suppressing.get()).isNotSameAs(acting.get());
        assertThat(asking.get().isDaemon()).isTrue();
    }

    @Test
    void nobodyIsAskedBeforeGo() {
        new Arbitrator(all);
        assertThat(high.asked.get()).isZero();
    }

    @Test
    void creationPrintsOneLine() {
        PrintStream console = System.out;
        ByteArrayOutputStream printed = new ByteArrayOutputStream();
        System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
        try {
            new Arbitrator(all);
        } finally {
            System.setOut(console);
        }
        assertThat(printed.toString(StandardCharsets.UTF_8)).isEqualTo("Arbitrator created" + System.lineSeparator());
    }

    private static void end(AtomicReference<String> first, String name, Arbitrator arbitrator) {
        first.compareAndSet(null, name);
        arbitrator.stop();
    }

    private static void await(CountDownLatch latch) {
        try {
            assertThat(latch.await(5, TimeUnit.SECONDS)).isTrue();
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    @Test
    @SuppressWarnings("deprecation")
    void startIsGoByItsOldName() {
        int[] actions = new int[1];
        Arbitrator[] arbitrator = new Arbitrator[1];
        Behavior once = new Behavior() {
            @Override
            public boolean takeControl() {
                return true;
            }

            @Override
            public void action() {
                actions[0]++;
                arbitrator[0].stop();
            }

            @Override
            public void suppress() {}
        };
        arbitrator[0] = new Arbitrator(new Behavior[] {once});
        arbitrator[0].start();
        assertThat(actions[0]).isEqualTo(1);
    }
}
