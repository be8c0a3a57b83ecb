package lejos.hardware.sensor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import lejos.hardware.AttachedBrick;
import lejos.hardware.port.AnalogPort;
import lejos.hardware.port.Port;
import lejos.hardware.port.SensorPort;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;

/** What a program's own sensor class gets from its base. */
class SensorBasesTest {
    @RegisterExtension
    final AttachedBrick brick = new AttachedBrick();

    /** A serial sensor written by a program. */
    private static final class OwnSerialSensor extends UARTSensor {
        OwnSerialSensor(Port port, int mode) {
            super(port, mode);
        }

        int hardwareMode() {
            return currentMode;
        }
    }

    /** An analogue sensor written by a program. */
    private static final class OwnAnalogSensor extends AnalogSensor {
        OwnAnalogSensor(Port port) {
            super(port);
        }

        OwnAnalogSensor(Port port, int type) {
            super(port, type, MODE_RAW);
        }

        OwnAnalogSensor(AnalogPort port) {
            super(port);
        }
    }

    private OwnSerialSensor serial(int mode) {
        brick.sensor(0).plugUart(99, "own", "A", "B", "C");
        OwnSerialSensor sensor = new OwnSerialSensor(SensorPort.S1, mode);
        brick.sensor(0).log().clear();
        return sensor;
    }

    @Test
    void theHardwareModeIsNotTheListIndex() {
        OwnSerialSensor sensor = serial(2);
        sensor.setModes(new SensorMode[] {null, null});
        sensor.setCurrentMode(1);
        assertEquals(2, sensor.hardwareMode());
        assertEquals(1, sensor.getCurrentMode());
    }

    @Test
    void switchingToThePresentModeDoesNothing() {
        OwnSerialSensor sensor = serial(1);
        sensor.switchMode(1, 10_000);
        sensor.switchMode(0, 10_000);
        assertEquals(List.of("mode 0"), brick.sensor(0).log());
    }

    @Test
    void modeMinusOneResetsTheDevice() {
        OwnSerialSensor sensor = serial(0);
        sensor.switchMode(-1, 0);
        assertEquals(-1, sensor.hardwareMode());
        sensor.switchMode(0, 0);
        assertEquals(List.of("reset", "initialise 0"), brick.sensor(0).log());
    }

    @Test
    void aRefusedModeThrowsAndThePresentOneStays() {
        OwnSerialSensor sensor = serial(0);
        var refusal = assertThrows(IllegalArgumentException.class, () -> sensor.switchMode(3, 0));
        assertEquals("Invalid sensor mode", refusal.getMessage());
        assertEquals(0, sensor.hardwareMode());
    }

    @Test
    void voltagesAreNormalisedAndConvertedToTheNxtsScale() {
        OwnAnalogSensor sensor = new OwnAnalogSensor(SensorPort.S1);
        assertEquals(0.5f, sensor.normalize(2.5f));
        assertEquals(511.5f, sensor.NXTRawValue(2.5f));
        assertEquals(512, sensor.NXTRawIntValue(2.5f));
        assertEquals(1023, sensor.NXTRawIntValue(5));
        assertEquals(0, sensor.NXTRawIntValue(0));
    }

    @Test
    void analogueSensorsSetTheirTypeOnPortsTheyOpenThemselves() {
        new OwnAnalogSensor(SensorPort.S1);
        new OwnAnalogSensor(SensorPort.S2, 2);
        new OwnAnalogSensor(SensorPort.S3.open(AnalogPort.class));
        assertEquals(List.of("expect AnalogSensor", "type 9"), withBaseName(0));
        assertEquals(List.of("expect AnalogSensor", "type 2"), withBaseName(1));
        assertEquals(List.of("expect AnalogSensor"), withBaseName(2));
    }

    /** This test's own classes lie in a leJOS package and are announced by their own names. */
    private List<String> withBaseName(int port) {
        return brick.sensor(port).log().stream().map(entry ->
                entry.replace("OwnAnalogSensor", "AnalogSensor")).toList();
    }

    @Test
    void theTypeIsSwitchedOnlyWhenItDiffers() {
        OwnAnalogSensor sensor = new OwnAnalogSensor(SensorPort.S1);
        brick.sensor(0).log().clear();
        sensor.switchType(9, 0);
        sensor.switchType(9, 0);
        sensor.switchType(5, 1);
        assertEquals(List.of("type 9", "type 5"), brick.sensor(0).log());
        assertThrows(IllegalArgumentException.class, () -> sensor.switchType(18, 0));
        assertEquals(5, sensor.currentType);
    }
}
