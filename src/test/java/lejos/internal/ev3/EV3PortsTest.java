package lejos.internal.ev3;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import brickless.hardware.SensorSocket.Wiring;
import java.util.List;
import lejos.hardware.AttachedBrick;
import lejos.hardware.motor.EV3MediumRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.hardware.port.Port;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3ColorSensor;
import lejos.hardware.sensor.EV3TouchSensor;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.hardware.sensor.I2CSensor;
import lejos.hardware.sensor.UARTSensor;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;

class EV3PortsTest {
    @RegisterExtension
    final AttachedBrick brick = new AttachedBrick();

    /** What a program writes to give a touch sensor a method it misses. */
    private static final class Bumper extends EV3TouchSensor {
        Bumper(Port port) {
            super(port);
        }
    }

    private static final class Arm extends EV3MediumRegulatedMotor {
        Arm(Port port) {
            super(port);
        }
    }

    private static final class OwnSerialSensor extends UARTSensor {
        OwnSerialSensor(Port port) {
            super(port);
        }
    }

    private static final class OwnBusSensor extends I2CSensor {
        OwnBusSensor(Port port) {
            super(port);
        }
    }

    @Test
    void everyWayToAPortLeadsToTheSameObject() {
        assertSame(SensorPort.S1, EV3Ports.sensorPort(0));
        assertSame(SensorPort.S4, EV3Ports.sensorPort(3));
        assertSame(MotorPort.A, EV3Ports.motorPort(0));
        assertSame(MotorPort.D, EV3Ports.motorPort(3));
    }

    @Test
    void aClassOfTheProgramCountsAsTheLejosClassItExtends() {
        new Bumper(SensorPort.S1);
        new Arm(MotorPort.A);
        brick.sensor(1).plugUart(99, "own", "MODE");
        new OwnSerialSensor(SensorPort.S2);
        new OwnBusSensor(SensorPort.S3);
        assertEquals("expect EV3TouchSensor", brick.sensor(0).log().get(0));
        assertEquals("expect UARTSensor", brick.sensor(1).log().get(0));
        assertEquals("expect I2CSensor", brick.sensor(2).log().get(0));
        assertEquals("expect EV3MediumRegulatedMotor", brick.motor(0).log().get(0));
    }

    @Test
    void theSimulatorHearsOfTheDeviceBeforeItIsUsed() {
        brick.sensor(0).plugUart(29, "ev3-color", "COL-REFLECT");
        new EV3ColorSensor(SensorPort.S1);
        assertEquals(List.of("expect EV3ColorSensor", "initialise 0"), brick.sensor(0).log());
    }

    @Test
    void aMissingSensorIsExplainedInTheCause() {
        var refusal = assertThrows(IllegalArgumentException.class, () -> new EV3ColorSensor(SensorPort.S1));
        assertEquals("Invalid sensor mode", refusal.getMessage());
        assertEquals("nothing is plugged into S1, but the program wants EV3ColorSensor there: add a sensor with"
                + " data-port=\"S1\" data-sensor=\"ev3-color\" to the robot's SVG, or use --robot auto",
                        refusal.getCause().getMessage());
    }

    @Test
    void aWrongSensorIsNamed() {
        brick.sensor(0).plug(Wiring.ANALOG, 16, "ev3-touch");
        var refusal = assertThrows(IllegalArgumentException.class, () -> new OwnSerialSensor(SensorPort.S1));
        assertEquals("S1 has ev3-touch plugged in, but the program's OwnSerialSensor wants a serial sensor (ev3-color,"
                + " ev3-gyro, ev3-infrared, ev3-ultrasonic) there", refusal.getCause().getMessage());
    }

    @Test
    void aSensorInTheWrongPortIsFound() {
        brick.sensor(0).plug(Wiring.ANALOG, 16, "ev3-touch");
        brick.sensor(3).plugUart(30, "ev3-ultrasonic", "US-DIST-CM");
        var refusal = assertThrows(IllegalArgumentException.class, () -> new EV3UltrasonicSensor(SensorPort.S1));
        assertEquals("S1 has ev3-touch plugged in, but the program wants EV3UltrasonicSensor there: put data-sensor="
                + "\"ev3-ultrasonic\" there in the robot's SVG, open it on S4, where the robot has its "
                        + "ev3-ultrasonic, or use"
                + " --robot auto", refusal.getCause().getMessage());
    }
}
