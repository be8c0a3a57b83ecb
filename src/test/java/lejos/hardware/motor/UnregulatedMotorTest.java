package lejos.hardware.motor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import lejos.hardware.AttachedBrick;
import lejos.hardware.DeviceException;
import lejos.hardware.port.BasicMotorPort;
import lejos.hardware.port.MotorPort;
import lejos.hardware.port.TachoMotorPort;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;

class UnregulatedMotorTest {
    @RegisterExtension
    final AttachedBrick brick = new AttachedBrick();
    private UnregulatedMotor motor;

    @BeforeEach
    void plugIn() {
        motor = new UnregulatedMotor(MotorPort.A);
    }

    private void expectCommands(String... commands) {
        List<String> expected = new ArrayList<>(List.of("expect UnregulatedMotor"));
        expected.addAll(List.of(commands));
        assertEquals(expected, brick.motor(0).log());
    }

    @Test
    void nothingHappensAtFirst() {
        expectCommands();
        assertEquals(0, motor.getPower());
        assertFalse(motor.isMoving());
    }

    @Test
    void powerAloneStartsTheMotorAlthoughItIsNotMoving() {
        motor.setPower(40);
        expectCommands("drive 40");
        assertFalse(motor.isMoving());
    }

    @Test
    void directionsApplyThePowerAndRepetitionsDoNothing() {
        motor.setPower(30);
        motor.forward();
        motor.forward();
        motor.backward();
        motor.backward();
        expectCommands("drive 30", "drive 30", "drive -30");
        assertTrue(motor.isMoving());
    }

    @Test
    void powerIsAppliedAtOnceWhileRunningAndMayReverse() {
        motor.backward();
        motor.setPower(20);
        motor.setPower(-30);
        expectCommands("drive 0", "drive -20", "drive 30");
        assertEquals(-30, motor.getPower());
        assertTrue(motor.isMoving());
    }

    @Test
    void powerAfterStopOrFloatIsRememberedForTheNextStart() {
        motor.forward();
        motor.stop();
        motor.setPower(50);
        motor.flt();
        motor.setPower(60);
        assertFalse(motor.isMoving());
        motor.forward();
        expectCommands("drive 0", "brake", "brake", "coast", "coast", "drive 60");
    }

    @Test
    void thePwmModeIsIgnored() {
        motor.close();
        new UnregulatedMotor(MotorPort.A, BasicMotorPort.PWM_FLOAT).forward();
        expectCommands("release", "expect UnregulatedMotor", "drive 0");
    }

    @Test
    void theEncoderIsTheHardwaresOwn() {
        brick.motor(0).turnByHand(45);
        assertEquals(45, motor.getTachoCount());
        motor.resetTachoCount();
        assertEquals(0, motor.getTachoCount());
        expectCommands("resetTacho");
    }

    @Test
    void aTakenPortIsRefused() {
        var refusal = assertThrows(DeviceException.class, () -> new UnregulatedMotor(MotorPort.A));
        assertEquals("unable to open port", refusal.getMessage());
    }

    @Test
    void closingFreesThePortUnlessItWasGivenOpen() {
        motor.close();
        TachoMotorPort port = MotorPort.A.open(TachoMotorPort.class);
        new UnregulatedMotor(port).close();
        new UnregulatedMotor(port, BasicMotorPort.PWM_BRAKE).close();
        assertEquals(0, port.getTachoCount());
    }

    @Test
    void anRcxMotorIsDrivenTheSameWay() {
        RCXMotor plain = new RCXMotor(MotorPort.B);
        plain.setPower(100);
        plain.backward();
        plain.close();
        new RCXMotor(MotorPort.B.open(BasicMotorPort.class)).flt();
        assertEquals(List.of("expect RCXMotor", "drive 100", "drive -100", "release", "expect RCXMotor", "coast"),
                brick.motor(1).log());
    }
}
