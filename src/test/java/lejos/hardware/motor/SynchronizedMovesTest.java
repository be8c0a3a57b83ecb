package lejos.hardware.motor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.Proxy;
import java.util.List;
import lejos.hardware.AttachedBrick;
import lejos.hardware.port.MotorPort;
import lejos.hardware.port.TachoMotorPort;
import lejos.robotics.RegulatedMotor;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;

class SynchronizedMovesTest {
    @RegisterExtension
    final AttachedBrick brick = new AttachedBrick();
    private EV3LargeRegulatedMotor left;
    private EV3LargeRegulatedMotor right;

    @BeforeEach
    void plugIn() {
        left = new EV3LargeRegulatedMotor(MotorPort.B);
        right = new EV3LargeRegulatedMotor(MotorPort.C);
        left.synchronizeWith(new RegulatedMotor[] {right});
    }

    @Test
    void movesOfABlockStartTogether() {
        left.startSynchronization();
        left.rotate(360);
        right.rotate(-360);
        assertTrue(brick.motor(1).moves().isEmpty());
        assertTrue(brick.motor(2).moves().isEmpty());
        left.endSynchronization();
        assertEquals(List.of("[1, 2]"), brick.get().groups());
        assertTrue(left.isMoving());
        left.waitComplete();
        right.waitComplete();
        assertEquals(360, left.getTachoCount());
        assertEquals(-360, right.getTachoCount());
    }

    @Test
    void theLastMoveOfEachMotorCounts() {
        left.startSynchronization();
        left.forward();
        left.rotateTo(90);
        right.backward();
        left.endSynchronization();
        assertEquals(90, brick.motor(1).lastMove().limitDegrees());
        assertEquals(1, brick.motor(1).moves().size());
    }

    @Test
    void gettersReportTheSnapshotInsideTheBlock() {
        left.rotate(100);
        right.forward();
        brick.advance(100);
        int before = right.getTachoCount();
        left.startSynchronization();
        brick.advance(100);
        assertEquals(before, right.getTachoCount());
        assertTrue(right.isMoving());
        left.forward();
        assertFalse(left.isMoving());
        left.endSynchronization();
        assertTrue(right.getTachoCount() > before);
        assertTrue(left.isMoving());
    }

    @Test
    void aPartnersTachoUsesItsOwnZeroInsideTheBlock() {
        left.rotate(100);
        left.resetTachoCount();
        right.rotate(50);
        left.startSynchronization();
        assertEquals(0, left.getTachoCount());
        assertEquals(50, right.getTachoCount());
    }

    @Test
    void aMotorWithoutARecordedMoveGoesOn() {
        right.forward();
        brick.advance(100);
        left.startSynchronization();
        left.rotate(90, true);
        left.endSynchronization();
        assertEquals(List.of("[1]"), brick.get().groups());
        assertEquals(1, brick.motor(2).moves().size());
    }

    @Test
    void anEmptyBlockSendsNothing() {
        left.startSynchronization();
        left.endSynchronization();
        assertEquals(List.of(), brick.get().groups());
        left.forward();
        assertEquals(1, brick.motor(1).moves().size());
    }

    @Test
    void aForgottenEndSwallowsEverything() {
        left.startSynchronization();
        left.forward();
        right.stop();
        left.waitComplete();
        brick.advance(1000);
        assertTrue(brick.motor(1).moves().isEmpty());
        assertTrue(brick.motor(2).moves().isEmpty());
    }

    @Test
    void aSpeedSetInTheBlockCountsForItsLaterMoves() {
        left.startSynchronization();
        left.setSpeed(500);
        left.forward();
        left.endSynchronization();
        assertEquals(500, brick.motor(1).lastMove().speedDegreesPerSecond());
    }

    @Test
    void aSpeedSetInTheBlockChangesARunningMotorAtItsEnd() {
        right.forward();
        brick.advance(100);
        left.startSynchronization();
        right.setSpeed(100);
        assertEquals(1, brick.motor(2).moves().size());
        left.endSynchronization();
        assertEquals(100, brick.motor(2).lastMove().speedDegreesPerSecond());
    }

    @Test
    void anIdenticalImmediateRequestIsNotRecorded() {
        left.forward();
        left.startSynchronization();
        left.forward();
        left.endSynchronization();
        assertEquals(List.of(), brick.get().groups());
    }

    @Test
    void aMotorAloneIsAGroupOfItsOwn() {
        right.startSynchronization();
        right.forward();
        right.endSynchronization();
        assertEquals(List.of("[2]"), brick.get().groups());
    }

    @Test
    void partnersReplaceTheOnesBeforeAndMayBeNone() {
        left.synchronizeWith(new RegulatedMotor[0]);
        left.startSynchronization();
        right.forward();
        assertEquals(1, brick.motor(2).moves().size());
    }

    @Test
    void allFourMotorsCanStartTogether() {
        EV3MediumRegulatedMotor arm = new EV3MediumRegulatedMotor(MotorPort.A);
        NXTRegulatedMotor claw = new NXTRegulatedMotor(MotorPort.D);
        arm.synchronizeWith(new RegulatedMotor[] {left, right, claw});
        arm.startSynchronization();
        for (RegulatedMotor motor : new RegulatedMotor[] {claw, right, left, arm}) {
            motor.forward();
        }
        arm.endSynchronization();
        assertEquals(List.of("[0, 1, 2, 3]"), brick.get().groups());
    }

    @Test
    void aMotorCannotBeItsOwnPartner() {
        var refusal = assertThrows(IllegalArgumentException.class, () ->
                left.synchronizeWith(new RegulatedMotor[] {right, left}));
        assertEquals("Can't synchronize with self", refusal.getMessage());
    }

    @Test
    void aPartnerWithAnotherRegulatorIsRefused() {
        TachoMotorPort port = MotorPort.A.open(TachoMotorPort.class);
        BaseRegulatedMotor other =
                new BaseRegulatedMotor(port, new JavaMotorRegulator(port), 9, 1, 0, 0, 1, 0, 0, 0, 1000) {};
        assertThrows(IllegalArgumentException.class, () -> left.synchronizeWith(new RegulatedMotor[] {other}));
    }

    @Test
    void onlyBaseRegulatedMotorsCanBePartners() {
        RegulatedMotor proxy = (RegulatedMotor) Proxy.newProxyInstance(
                getClass().getClassLoader(), new Class<?>[] {RegulatedMotor.class},
                (object, method, arguments) -> null);
        assertThrows(ClassCastException.class, () -> left.synchronizeWith(new RegulatedMotor[] {proxy}));
    }
}
