package lejos.hardware.motor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import brickless.hardware.fake.FakeBrick;
import brickless.hardware.fake.RobotRealm;
import lejos.hardware.DeviceException;
import lejos.hardware.port.MotorPort;
import org.junit.jupiter.api.Test;

/** The class with four ready-made motors, each time as a fresh program meets it. */
class MotorTest {
    /** Uses one of the four motors, then wants one of its own. */
    public static final class UsesMotorThenItsOwn implements Runnable {
        @Override
        public void run() {
            Motor.A.rotate(90);
            assertEquals(90, Motor.A.getTachoCount());
            assertThrows(DeviceException.class, () -> new EV3LargeRegulatedMotor(MotorPort.D));
        }
    }

    /** Has a motor of its own, then uses one of the four. */
    public static final class UsesItsOwnThenMotor implements Runnable {
        @Override
        public void run() {
            new EV3LargeRegulatedMotor(MotorPort.D);
            var failure = assertThrows(ExceptionInInitializerError.class, () -> Motor.A.forward());
            assertEquals(DeviceException.class, failure.getCause().getClass());
            assertThrows(NoClassDefFoundError.class, () -> Motor.B.forward());
            assertThrows(DeviceException.class, () -> new EV3LargeRegulatedMotor(MotorPort.C));
        }
    }

    /** Touches the ports only. */
    public static final class TouchesPorts implements Runnable {
        @Override
        public void run() {
            assertEquals("A", MotorPort.A.getName());
            new EV3LargeRegulatedMotor(MotorPort.A);
        }
    }

    @Test
    void touchingOneMotorOpensAllFourPorts() {
        FakeBrick brick = new FakeBrick();
        RobotRealm.run(brick, UsesMotorThenItsOwn.class);
        for (int port = 0; port < 4; port++) {
            assertEquals("expect NXTRegulatedMotor", brick.motor(port).log().get(0));
        }
    }

    @Test
    void anOpenPortPreventsTheFour() {
        RobotRealm.run(new FakeBrick(), UsesItsOwnThenMotor.class);
    }

    @Test
    void touchingThePortsOpensNothing() {
        RobotRealm.run(new FakeBrick(), TouchesPorts.class);
    }

    @Test
    void everyProgramHasMotorsOfItsOwn() {
        RobotRealm.run(new FakeBrick(), UsesMotorThenItsOwn.class);
        RobotRealm.run(new FakeBrick(), UsesMotorThenItsOwn.class);
    }
}
