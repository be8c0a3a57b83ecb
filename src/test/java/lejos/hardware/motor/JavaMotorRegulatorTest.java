package lejos.hardware.motor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import lejos.hardware.port.BasicMotorPort;
import lejos.robotics.RegulatedMotor;
import lejos.robotics.RegulatedMotorListener;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * The software regulator with its own thread on a simulated motor. Every test ends when the regulator says so, however
 * fast it runs.
 */
@Timeout(30)
class JavaMotorRegulatorTest {
    private final SimulatedMotorPort port = new SimulatedMotorPort();
    private final JavaMotorRegulator regulator = new JavaMotorRegulator(port);
    private final List<String> events = Collections.synchronizedList(new ArrayList<>());
    private BaseRegulatedMotor motor;

    @BeforeEach
    void plugIn() {
        motor = new BaseRegulatedMotor(port, regulator, 9, 1, 2, 3, 4, 5, 6, 0, 1000) {};
        motor.setSpeed(700);
    }

    @AfterEach
    void letGo() {
        motor.flt();
    }

    private void listen() {
        motor.addListener(new RegulatedMotorListener() {
            @Override
            public void rotationStarted(RegulatedMotor source, int tachoCount, boolean stalled, long timeStamp) {
                events.add("started");
            }

            @Override
            public void rotationStopped(RegulatedMotor source, int tachoCount, boolean stalled, long timeStamp) {
                events.add(stalled ? "stalled" : "stopped");
            }
        });
    }

    @Test
    void aMoveEndsAtItsTarget() {
        listen();
        motor.rotate(90);
        assertEquals(90, motor.getTachoCount(), 3);
        assertEquals(90, motor.getPosition(), 0.01);
        assertFalse(motor.isMoving());
        motor.rotateTo(-20);
        assertEquals(-20, motor.getTachoCount(), 3);
        assertEquals(List.of("started", "stopped", "started", "stopped"), events);
    }

    @Test
    void aReversalSlowsDownToZeroWithEvents() throws InterruptedException {
        listen();
        motor.rotate(400, true);
        port.awaitDegrees(100);
        motor.rotateTo(0);
        assertEquals(0, motor.getTachoCount(), 3);
        assertEquals(List.of("started", "stopped", "started", "stopped"), events);
    }

    @Test
    void aBlockedMotorStalls() {
        listen();
        motor.setStallThreshold(10, 80);
        port.block();
        motor.rotate(360);
        assertTrue(motor.isStalled());
        assertFalse(motor.isMoving());
        assertEquals(List.of("started", "stalled"), events);
    }

    @Test
    void theInitialStallTimeIsCountedInPeriods() {
        assertEquals(1000, regulator.stallTime);
        motor.setStallThreshold(50, 1000);
        assertEquals(250, regulator.stallTime);
        assertEquals(50, regulator.stallLimit);
    }

    @Test
    void resettingTheTachoFloatsTheMotorAndClearsTheHardwareCount() {
        motor.rotate(45);
        motor.resetTachoCount();
        assertEquals(0, port.getTachoCount());
        assertEquals(0, motor.getPosition());
        assertEquals(BasicMotorPort.FLOAT, port.lastMode());
    }

    @Test
    void stopHoldsAndFloatLetsGo() {
        motor.forward();
        motor.stop();
        assertFalse(motor.isMoving());
        motor.flt();
        assertEquals(BasicMotorPort.FLOAT, port.lastMode());
        assertEquals(0, regulator.power);
    }

    @Test
    void floatingTheModelFollowsTheEncoder() {
        motor.rotate(30);
        motor.flt();
        assertEquals(port.getTachoCount(), motor.getPosition());
    }

    @Test
    void aPeriodThatIsUnderWayLeavesAMotorAloneThatWasLetGo() {
        motor.rotate(30);
        motor.flt();
        int looks = port.looks();
        regulator.readEncoder();
        regulator.compute(4);
        regulator.writePower();
        assertEquals(looks, port.looks());
        assertEquals(BasicMotorPort.FLOAT, port.lastMode());
    }

    @Test
    void speedIsChangedWhileRunning() throws InterruptedException {
        motor.setSpeed(100);
        motor.forward();
        motor.setSpeed(300);
        port.awaitDegrees(60);
        assertEquals(300, motor.getRotationSpeed());
        assertTrue(motor.isMoving());
    }

    @Test
    void limitsAreRemembered() {
        motor.rotateTo(33, true);
        assertEquals(33, motor.getLimitAngle());
        motor.waitComplete();
        motor.stop();
        assertEquals(MotorRegulator.NO_LIMIT, motor.getLimitAngle());
    }

    @Test
    void constructionSelectsBrakingPulses() {
        assertEquals(BasicMotorPort.PWM_BRAKE, port.pwmMode());
    }

    @Test
    void synchronisationDoesNothing() {
        motor.startSynchronization();
        motor.rotate(20);
        motor.endSynchronization();
        assertEquals(20, motor.getTachoCount(), 3);
    }
}
