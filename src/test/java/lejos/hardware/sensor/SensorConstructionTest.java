package lejos.hardware.sensor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.function.Function;
import lejos.hardware.AttachedBrick;
import lejos.hardware.DeviceException;
import lejos.hardware.port.AnalogPort;
import lejos.hardware.port.I2CException;
import lejos.hardware.port.MotorPort;
import lejos.hardware.port.Port;
import lejos.hardware.port.SensorPort;
import lejos.hardware.port.UARTPort;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;

/** Which constructor does what on which port, with the right sensor, the wrong one or none. */
class SensorConstructionTest {
    private static final List<Function<Port, BaseSensor>> SERIAL = List.of(
            EV3UltrasonicSensor::new, EV3ColorSensor::new, EV3GyroSensor::new, EV3IRSensor::new);
    private static final List<Function<UARTPort, BaseSensor>> SERIAL_ON_OPEN_PORT = List.of(
            EV3UltrasonicSensor::new, EV3ColorSensor::new, EV3GyroSensor::new, EV3IRSensor::new);
    private static final List<Integer> FIRST_HARDWARE_MODES = List.of(0, 0, 3, 0);
    private static final List<Function<Port, BaseSensor>> ANALOG = List.of(
            EV3TouchSensor::new, NXTTouchSensor::new, NXTLightSensor::new, NXTSoundSensor::new, RCXLightSensor::new);
    private static final List<Port> PORTS = List.of(SensorPort.S1, SensorPort.S2, SensorPort.S3, SensorPort.S4);

    @RegisterExtension
    final AttachedBrick brick = new AttachedBrick();

    private void plugSerial(int port) {
        brick.sensor(port).plugUart(30, "any", "M0", "M1", "M2", "M3", "M4", "M5");
    }

    @Test
    void serialSensorsConnectInTheirModeOnEveryPort() {
        for (int i = 0; i < 16; i++) {
            plugSerial(i / 4);
            BaseSensor sensor = SERIAL.get(i % 4).apply(PORTS.get(i / 4));
            assertTrue(brick.sensor(i / 4).log().contains("initialise " + FIRST_HARDWARE_MODES.get(i % 4)),
                    "case " + i);
            sensor.close();
            brick.sensor(i / 4).log().clear();
        }
    }

    @Test
    void aTakenPortIsRefused() {
        for (int i = 0; i < 9; i++) {
            Function<Port, BaseSensor> sensor = i < 4 ? SERIAL.get(i) : ANALOG.get(i - 4);
            if (i == 0) {
                SensorPort.S1.open(AnalogPort.class);
            }
            var refusal = assertThrows(DeviceException.class, () -> sensor.apply(SensorPort.S1), "case " + i);
            assertEquals("unable to open port", refusal.getMessage());
        }
    }

    @Test
    void aMotorPortIsRefused() {
        for (int i = 0; i < 9; i++) {
            Function<Port, BaseSensor> sensor = i < 4 ? SERIAL.get(i) : ANALOG.get(i - 4);
            var refusal = assertThrows(IllegalArgumentException.class, () -> sensor.apply(MotorPort.A), "case " + i);
            assertEquals("Invalid port interface", refusal.getMessage());
        }
    }

    @Test
    void aMissingSerialSensorIsRefusedAndThePortIsFree() {
        for (int i = 0; i < 4; i++) {
            Function<Port, BaseSensor> sensor = SERIAL.get(i);
            var refusal = assertThrows(IllegalArgumentException.class, () -> sensor.apply(SensorPort.S1), "case " + i);
            assertEquals("Invalid sensor mode", refusal.getMessage());
            SensorPort.S1.open(UARTPort.class).close();
        }
    }

    @Test
    void aMissingSerialSensorOnAnOpenPortIsADeviceException() {
        UARTPort port = SensorPort.S1.open(UARTPort.class);
        for (int i = 0; i < 4; i++) {
            Function<UARTPort, BaseSensor> sensor = SERIAL_ON_OPEN_PORT.get(i);
            var refusal = assertThrows(DeviceException.class, () -> sensor.apply(port), "case " + i);
            assertEquals("Unable to initialize device", refusal.getMessage());
        }
    }

    @Test
    void anOpenPortStaysOpenWhenItsSensorIsClosed() {
        plugSerial(0);
        UARTPort port = SensorPort.S1.open(UARTPort.class);
        for (Function<UARTPort, BaseSensor> sensor : SERIAL_ON_OPEN_PORT) {
            sensor.apply(port).close();
        }
        assertThrows(DeviceException.class, () -> SensorPort.S1.open(UARTPort.class));
    }

    @Test
    void anotherSerialSensorIsNotNoticedUnlessItLacksTheMode() {
        brick.sensor(0).plugUart(29, "ev3-color", "COL-REFLECT", "COL-AMBIENT", "COL-COLOR");
        new EV3IRSensor(SensorPort.S1).close();
        assertThrows(IllegalArgumentException.class, () -> new EV3GyroSensor(SensorPort.S1));
    }

    @Test
    void aMissingAnalogueSensorIsNeverNoticed() {
        for (int i = 0; i < ANALOG.size(); i++) {
            BaseSensor sensor = ANALOG.get(i).apply(SensorPort.S1);
            sensor.fetchSample(new float[sensor.sampleSize()], 0);
            sensor.close();
        }
    }

    @Test
    void aMissingNxtUltrasonicSensorFailsAndKeepsThePort() {
        var silence = assertThrows(I2CException.class, () -> new NXTUltrasonicSensor(SensorPort.S1));
        assertEquals("I2C I/O error", silence.getMessage());
        assertThrows(DeviceException.class, () -> new NXTUltrasonicSensor(SensorPort.S1));
    }

    @Test
    void closingASensorFreesItsPort() {
        plugSerial(0);
        for (int i = 0; i < 9; i++) {
            Function<Port, BaseSensor> sensor = i < 4 ? SERIAL.get(i) : ANALOG.get(i - 4);
            BaseSensor opened = sensor.apply(SensorPort.S1);
            opened.close();
            opened.close();
        }
    }
}
