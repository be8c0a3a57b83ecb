package lejos.hardware.motor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import lejos.hardware.AttachedBrick;
import lejos.hardware.port.MotorPort;
import lejos.robotics.RegulatedMotor;
import lejos.robotics.RegulatedMotorListener;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;

class MotorListenerTest {
    @RegisterExtension
    final AttachedBrick brick = new AttachedBrick();
    private final Recorder recorder = new Recorder();
    private EV3LargeRegulatedMotor motor;

    /** Notes events; the latch opens with the first stop. */
    private static final class Recorder implements RegulatedMotorListener {
        private final List<String> events = new ArrayList<>();
        private final CountDownLatch stopped = new CountDownLatch(1);
        private RegulatedMotor source;
        private Thread thread;

        @Override
        public void rotationStarted(RegulatedMotor motor, int tachoCount, boolean stalled, long timeStamp) {
            source = motor;
            thread = Thread.currentThread();
            note("started " + tachoCount + (motor.isMoving() ? " moving" : "") + (stalled ? " stalled" : ""));
        }

        @Override
        public void rotationStopped(RegulatedMotor motor, int tachoCount, boolean stalled, long timeStamp) {
            note("stopped " + tachoCount + (motor.isMoving() ? " moving" : "") + (stalled ? " stalled" : ""));
            stopped.countDown();
        }

        private synchronized void note(String event) {
            events.add(event);
        }

        synchronized List<String> events() {
            return List.copyOf(events);
        }
    }

    @BeforeEach
    void plugIn() {
        motor = new EV3LargeRegulatedMotor(MotorPort.A);
        motor.addListener(recorder);
    }

    @Test
    void aBlockingMoveStartsAndStopsOnTheCallingThread() {
        motor.rotate(90);
        assertEquals(List.of("started 0", "stopped 90"), recorder.events());
        assertSame(motor, recorder.source);
        assertSame(Thread.currentThread(), recorder.thread);
    }

    @Test
    void blendedMovesReportNothingInBetween() {
        motor.forward();
        brick.advance(100);
        motor.backward();
        brick.advance(50);
        motor.setSpeed(100);
        motor.stop();
        assertEquals(2, recorder.events().size());
        assertEquals("started 0", recorder.events().get(0));
    }

    @Test
    void stoppingAnIdleMotorReportsNothing() {
        motor.stop();
        motor.flt();
        motor.stop(true);
        motor.rotate(0);
        motor.setSpeed(0);
        motor.forward();
        assertEquals(List.of(), recorder.events());
    }

    @Test
    void aStallIsReportedAsSuch() {
        brick.motor(0).block(true);
        motor.rotate(1000);
        assertEquals(List.of("started 0", "stopped 0 stalled"), recorder.events());
    }

    @Test
    void theEndOfAnImmediateMoveIsNoticedInTheBackground() throws InterruptedException {
        motor.rotate(10, true);
        brick.advance(500);
        assertTrue(recorder.stopped.await(5, TimeUnit.SECONDS));
        assertEquals(List.of("started 0", "stopped 10"), recorder.events());
    }

    @Test
    void theTachoIsTheUsersOwn() {
        motor.rotate(90);
        motor.resetTachoCount();
        motor.rotate(-30);
        assertEquals(List.of("started 0", "stopped 90", "started 0", "stopped -30"), recorder.events());
    }

    @Test
    void aListenerReplacesTheOneBefore() {
        Recorder second = new Recorder();
        motor.addListener(second);
        motor.rotate(90);
        assertEquals(List.of(), recorder.events());
        assertEquals(2, second.events().size());
        assertSame(second, motor.removeListener());
        assertNull(motor.removeListener());
    }

    @Test
    void aListenerAddedInMidMoveHearsTheStopOnly() {
        motor.removeListener();
        motor.rotate(90, true);
        brick.advance(50);
        motor.addListener(recorder);
        motor.waitComplete();
        assertEquals(List.of("stopped 90"), recorder.events());
    }

    @Test
    void aListenerAddedAfterAMoveHearsNothingOfIt() {
        motor.removeListener();
        motor.rotate(90, true);
        brick.advance(1000);
        motor.addListener(recorder);
        motor.stop();
        assertEquals(List.of(), recorder.events());
    }

    @Test
    void anExceptionOfTheListenerReachesTheCaller() {
        motor.addListener(new RegulatedMotorListener() {
            @Override
            public void rotationStarted(RegulatedMotor source, int tachoCount, boolean stalled, long timeStamp) {
                throw new IllegalStateException("on start");
            }

            @Override
            public void rotationStopped(RegulatedMotor source, int tachoCount, boolean stalled, long timeStamp) {
                throw new AssertionError("never started");
            }
        });
        String text = assertThrows(IllegalStateException.class, motor::forward).getMessage();
        assertEquals("on start", text);
    }
}
