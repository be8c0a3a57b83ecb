package lejos.hardware.motor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import brickless.hardware.MoveRequest;
import java.util.List;
import lejos.hardware.AttachedBrick;
import lejos.hardware.port.MotorPort;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;

/** Which requests the calls of a regulated motor become, and which of them are ignored. */
class RegulatedMotorMovesTest {
    private static final int FOREVER = 2147483647;

    @RegisterExtension
    final AttachedBrick brick = new AttachedBrick();
    private EV3LargeRegulatedMotor motor;

    @BeforeEach
    void plugIn() {
        motor = new EV3LargeRegulatedMotor(MotorPort.A);
    }

    private List<MoveRequest> moves() {
        return brick.motor(0).moves();
    }

    private static MoveRequest move(float speed, int acceleration, int limit, boolean hold) {
        return new MoveRequest(speed, acceleration, limit, hold);
    }

    @Test
    void constructionMovesNothing() {
        assertEquals(List.of(), moves());
        assertEquals(List.of("expect EV3LargeRegulatedMotor"), brick.motor(0).log());
        assertFalse(motor.isMoving());
    }

    @Test
    void forwardAndBackwardRunForEver() {
        motor.forward();
        motor.backward();
        assertEquals(List.of(move(360, 6000, FOREVER, true), move(360, 6000, -FOREVER, true)), moves());
    }

    @Test
    void stopDeceleratesAndHolds() {
        motor.forward();
        motor.stop(true);
        assertEquals(move(0, 6000, FOREVER, true), brick.motor(0).lastMove());
    }

    @Test
    void floatDeceleratesAndLetsGo() {
        motor.forward();
        brick.advance(100);
        motor.flt(true);
        assertEquals(move(0, 6000, FOREVER, false), brick.motor(0).lastMove());
        assertTrue(motor.isMoving());
    }

    @Test
    void stopAndFloatBlockUntilTheMotorStands() {
        motor.forward();
        brick.advance(100);
        motor.stop();
        assertFalse(motor.isMoving());
        motor.forward();
        motor.flt();
        assertFalse(motor.isMoving());
        motor.forward();
        assertTrue(motor.suspendRegulation());
        assertFalse(motor.isMoving());
    }

    @Test
    @SuppressWarnings("deprecation")
    void lockIsStop() {
        motor.forward();
        motor.lock(70);
        assertEquals(move(0, 6000, FOREVER, true), brick.motor(0).lastMove());
        assertFalse(motor.isMoving());
    }

    @Test
    void rotateBlocksUntilTheAngleIsReached() {
        motor.rotate(360);
        assertFalse(motor.isMoving());
        assertEquals(360, motor.getTachoCount());
        motor.rotateTo(-90);
        assertEquals(-90, motor.getTachoCount());
    }

    @Test
    void rotateReturnsAtOnceWhenAsked() {
        motor.rotate(360, true);
        assertTrue(motor.isMoving());
        assertEquals(0, motor.getTachoCount());
    }

    @Test
    void rotateCountsFromTheModelSoThatErrorsDoNotAddUp() {
        motor.rotate(90);
        brick.motor(0).turnByHand(-7);
        motor.rotate(90, true);
        assertEquals(180, motor.getLimitAngle());
    }

    @Test
    void rotateInTheMiddleOfAMoveCountsFromThePresentPosition() {
        motor.rotate(360, true);
        brick.advance(500);
        int here = Math.round(motor.getPosition());
        motor.rotate(10, true);
        assertEquals(here + 10, motor.getLimitAngle());
    }

    @Test
    void rotateToIsAbsoluteAndNotReducedTo360() {
        motor.rotateTo(720, true);
        assertEquals(move(360, 6000, 720, true), brick.motor(0).lastMove());
    }

    @Test
    void anIdenticalImmediateRequestIsIgnored() {
        for (int i = 0; i < 5; i++) {
            motor.forward();
            brick.advance(10);
        }
        motor.rotateTo(90, true);
        motor.rotateTo(90, true);
        assertEquals(2, moves().size());
    }

    @Test
    void aRequestThatDiffersInAnyPartIsExecuted() {
        for (int i = 0; i < 16; i++) {
            EV3MediumRegulatedMotor other = new EV3MediumRegulatedMotor(MotorPort.B);
            other.setSpeed(100);
            other.setAcceleration(1000);
            other.rotateTo(3600, true);
            int before = brick.motor(1).moves().size();
            brick.motor(1).block(true);
            other.speed = i % 2 == 0 ? 100 : 200;
            other.acceleration = i / 2 % 2 == 0 ? 1000 : 2000;
            other.reg.newMove(other.speed, other.acceleration, i / 4 % 2 == 0 ? 3600 : 3601, i / 8 == 0, false);
            assertEquals(i == 0 ? 0 : 1, brick.motor(1).moves().size() - before, "case " + i);
            other.flt(true);
            brick.motor(1).block(false);
            other.close();
        }
    }

    @Test
    void anIdenticalBlockingRequestIsExecuted() {
        motor.rotateTo(90);
        motor.rotateTo(90);
        assertEquals(2, moves().size());
    }

    @Test
    void afterAStallTheSameRequestIsExecutedAgain() {
        brick.motor(0).block(true);
        motor.rotateTo(1000);
        assertTrue(motor.isStalled());
        motor.rotateTo(1000, true);
        assertEquals(2, moves().size());
        assertFalse(motor.isStalled());
    }

    @Test
    void afterAResetTheSameAngleIsAnotherTarget() {
        motor.rotateTo(90);
        motor.resetTachoCount();
        motor.rotateTo(90, true);
        assertEquals(180, brick.motor(0).lastMove().limitDegrees());
    }

    @Test
    void speedIsChangedInARunningMove() {
        motor.forward();
        brick.advance(10);
        motor.setSpeed(720);
        assertTrue(brick.motor(0).log().contains("adjustSpeed 720.0"));
        brick.advance(200);
        assertEquals(720, motor.getRotationSpeed());
        motor.forward();
        assertEquals(1, moves().size(), "the same request with the new speed");
    }

    @Test
    void theSameSpeedChangesNothing() {
        motor.forward();
        motor.setSpeed(360);
        assertEquals(List.of("expect EV3LargeRegulatedMotor"), brick.motor(0).log());
    }

    @Test
    void speedDoesNotDisturbAStandingMotor() {
        motor.setSpeed(500);
        motor.rotate(90);
        motor.setSpeed(100);
        assertEquals(List.of("expect EV3LargeRegulatedMotor"), brick.motor(0).log());
        assertEquals(1, moves().size());
    }

    @Test
    void speedDoesNotDisturbTheFinalDeceleration() {
        motor.setAcceleration(100);
        motor.rotate(100, true);
        brick.advance(1500);
        assertTrue(motor.isMoving());
        motor.setSpeed(10);
        assertEquals(List.of("expect EV3LargeRegulatedMotor"), brick.motor(0).log());
    }

    @Test
    void speedZeroStopsAndLatches() {
        motor.forward();
        brick.advance(100);
        motor.setSpeed(0);
        assertEquals(move(0, 6000, FOREVER, true), brick.motor(0).lastMove());
        brick.advance(500);
        assertFalse(motor.isMoving());
        motor.setSpeed(300);
        brick.advance(500);
        assertFalse(motor.isMoving());
        motor.forward();
        assertTrue(motor.isMoving());
    }

    @Test
    void forwardAtSpeedZeroHolds() {
        motor.setSpeed(0);
        motor.forward();
        assertEquals(move(0, 6000, FOREVER, true), brick.motor(0).lastMove());
        assertFalse(motor.isMoving());
    }

    @Test
    void accelerationIsChangedInARunningMove() {
        motor.forward();
        brick.advance(10);
        motor.setAcceleration(-500);
        motor.setAcceleration(500);
        assertEquals(List.of("expect EV3LargeRegulatedMotor", "adjustAcceleration 500"), brick.motor(0).log());
        assertEquals(500, motor.getAcceleration());
    }

    @Test
    void resettingTheTachoMovesTheFrameAndNothingElse() {
        motor.rotateTo(90);
        motor.rotateTo(200, true);
        brick.advance(50);
        int here = motor.getTachoCount();
        motor.resetTachoCount();
        assertEquals(0, motor.getTachoCount());
        assertEquals(200, motor.getLimitAngle());
        motor.waitComplete();
        assertEquals(200 - here, motor.getTachoCount());
        assertEquals(200 - here, motor.getPosition());
        motor.rotateTo(0);
        assertEquals(here, brick.motor(0).tachoDegrees());
    }

    @Test
    void limitsAreReportedInTheUsersFrame() {
        motor.forward();
        assertEquals(FOREVER, motor.getLimitAngle());
        motor.backward();
        assertEquals(-FOREVER, motor.getLimitAngle());
        motor.stop();
        assertEquals(FOREVER, motor.getLimitAngle());
        motor.resetTachoCount();
        motor.rotateTo(45, true);
        assertEquals(45, motor.getLimitAngle());
        motor.flt(true);
        assertEquals(FOREVER, motor.getLimitAngle());
    }

    @Test
    void aBlockedMotorStallsStopsMovingAndHolds() {
        motor.setStallThreshold(10, 50);
        brick.motor(0).block(true);
        motor.rotate(360);
        assertTrue(motor.isStalled());
        assertFalse(motor.isMoving());
        assertEquals(0, motor.getRotationSpeed());
        assertTrue(brick.motor(0).log().contains("setStallThreshold 10 50"));
    }

    @Test
    void aStalledMotorIsNotStalledAnyMoreAfterTheNextRequest() {
        brick.motor(0).block(true);
        motor.rotate(360);
        motor.stop(true);
        assertFalse(motor.isStalled());
    }

    @Test
    void holdKeepsTheModelAtTheTarget() {
        motor.rotate(90);
        brick.motor(0).turnByHand(3);
        assertEquals(90, motor.getPosition());
        assertEquals(93, motor.getTachoCount());
    }

    @Test
    void otherThreadsCanCommandAMotorThatSomebodyWaitsFor() {
        boolean[] moving = new boolean[1];
        Thread other = new Thread(() -> {
            moving[0] = motor.isMoving();
            motor.rotateTo(20, true);
        });
        brick.motor(0).whileWaiting(() -> {
            other.start();
            join(other);
        });
        motor.rotateTo(1000);
        assertTrue(moving[0]);
        assertFalse(other.isAlive(), "the other thread was held up");
        assertEquals(20, motor.getTachoCount());
    }

    private static void join(Thread thread) {
        try {
            thread.join(5000);
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    @Test
    void waitingKeepsTheInterrupt() {
        motor.rotate(90, true);
        Thread.currentThread().interrupt();
        motor.waitComplete();
        assertTrue(Thread.interrupted());
        assertEquals(90, motor.getTachoCount());
    }
}
