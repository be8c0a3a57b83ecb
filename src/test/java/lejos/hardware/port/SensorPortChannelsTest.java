package lejos.hardware.port;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import brickless.hardware.I2cChannel.Status;
import brickless.hardware.SensorSocket.Wiring;
import java.util.List;
import java.util.Set;
import lejos.hardware.AttachedBrick;
import lejos.hardware.DeviceException;
import lejos.hardware.sensor.SensorConstants;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SensorPortChannelsTest {
    @RegisterExtension
    final AttachedBrick brick = new AttachedBrick();

    @Test
    void pinsAreReadInVolts() {
        AnalogPort port = SensorPort.S1.open(AnalogPort.class);
        brick.sensor(0).analog().raw(4095, 819);
        assertEquals(5.0f, port.getPin1());
        assertEquals(1.0f, port.getPin6());
    }

    @Test
    void analoguePortsRefuseTheTypesOfOtherWirings() {
        AnalogPort port = SensorPort.S1.open(AnalogPort.class);
        for (int type = -1; type <= 20; type++) {
            if (type != SensorConstants.TYPE_COLORFULL) {
                assertEquals(type >= 0 && type <= 17 && type != 12, port.setType(type), "type " + type);
            }
        }
    }

    @Test
    @SuppressWarnings("deprecation")
    void typeAndModeTogetherAlwaysSucceed() {
        AnalogPort port = SensorPort.S1.open(AnalogPort.class);
        assertTrue(port.setTypeAndMode(12, SensorConstants.MODE_RAW), "although the type is refused");
        assertFalse(port.setType(12));
        assertTrue(port.setMode(3));
        assertEquals(3, port.getMode());
        assertEquals(0, port.getType(), "always");
    }

    @Test
    void colourVoltagesAreCopiedAndMissingOnesAreZero() {
        AnalogPort port = SensorPort.S1.open(AnalogPort.class);
        brick.sensor(0).analog().colours(1, 2, 3, 0.5f, 5);
        float[] values = {9, 9, 9, 9};
        port.getFloats(values, 1, 2);
        assertArrayEquals(new float[] {9, 1, 2, 9}, values);
        brick.sensor(0).analog().colours();
        port.getFloats(values, 0, 4);
        assertArrayEquals(new float[4], values);
    }

    @Test
    void busTypesSelectSpeedAndVoltage() {
        I2CPort port = SensorPort.S2.open(I2CPort.class);
        for (int type = -1; type <= 20; type++) {
            assertEquals(Set.of(10, 11, 18, 19).contains(type), port.setType(type), "type " + type);
        }
        assertEquals(List.of("configure 10kHz", "configure 10kHz 9V", "configure 100kHz", "configure 100kHz 9V"),
                brick.sensor(1).log());
    }

    @Test
    void aDeadBusThrowsTheOriginalText() {
        I2CPort port = SensorPort.S2.open(I2CPort.class);
        var silence = assertThrows(I2CException.class, () ->
                port.i2cTransaction(2, new byte[1], 0, 1, new byte[8], 0, 8));
        assertEquals("I2C I/O error", silence.getMessage());
        brick.sensor(1).i2c().troubles(Status.BUSY);
        var busy = assertThrows(I2CException.class, () -> port.i2cTransaction(2, new byte[1], 0, 1, new byte[8], 0, 8));
        assertEquals("I2C Bus busy", busy.getMessage());
    }

    @Test
    void aTransactionWritesThenReads() {
        brick.sensor(1).plug(Wiring.I2C, 123, "nxt-ultrasonic").i2c().registers(0x42, 17, 18);
        byte[] answer = new byte[4];
        SensorPort.S2.open(I2CPort.class).i2cTransaction(2, new byte[] {0, 0x42}, 1, 1, answer, 1, 2);
        assertArrayEquals(new byte[] {0, 17, 18, 0}, answer);
    }

    @Test
    void aTransactionIsLimitedTo32BytesEachWay() {
        I2CPort port = SensorPort.S2.open(I2CPort.class);
        assertThrows(IllegalArgumentException.class, () -> port.i2cTransaction(2, new byte[33], 0, 33, null, 0, 0));
        assertThrows(IllegalArgumentException.class, () ->
                port.i2cTransaction(2, new byte[1], 0, 1, new byte[33], 0, 33));
    }

    @Test
    void theFirstModeConnectsAndLaterOnesSwitch() {
        brick.sensor(0).plugUart(32, "ev3-gyro", "GYRO-ANG", "GYRO-RATE", "GYRO-FAS", "GYRO-G&A");
        UARTPort port = SensorPort.S1.open(UARTPort.class);
        assertTrue(port.setMode(3));
        assertTrue(port.setMode(1));
        assertEquals(1, port.getMode());
        assertEquals(List.of("initialise 3", "mode 1"), brick.sensor(0).log());
    }

    @Test
    void unknownModesAreRefusedAndThePresentOneStays() {
        brick.sensor(0).plugUart(32, "ev3-gyro", "GYRO-ANG", "GYRO-RATE");
        UARTPort port = SensorPort.S1.open(UARTPort.class);
        port.setMode(1);
        for (int mode : new int[] {-2, 2, 7, 8, 100}) {
            assertFalse(port.setMode(mode), "mode " + mode);
        }
        assertEquals(1, port.getMode());
        assertEquals("GYRO-ANG", port.getModeName(0));
        assertEquals("Unknown", port.getModeName(5));
    }

    @Test
    void aResetSensorIsConnectedAnewByTheNextMode() {
        brick.sensor(0).plugUart(29, "ev3-color", "COL-REFLECT", "COL-AMBIENT");
        UARTPort port = SensorPort.S1.open(UARTPort.class);
        port.setMode(0);
        port.resetSensor();
        assertEquals(0, port.getByte());
        port.setMode(1);
        assertEquals(List.of("initialise 0", "reset", "initialise 1"), brick.sensor(0).log());
    }

    @Test
    void messagesAreSignedAndLittleEndian() {
        brick.sensor(0).plugUart(30, "ev3-ultrasonic", "US-DIST-CM");
        UARTPort port = SensorPort.S1.open(UARTPort.class);
        port.setMode(0);
        brick.sensor(0).uart().bytes(0, 0xfe, 0xff, 0x34, 0x12);
        assertEquals(-2, port.getByte());
        assertEquals(-2, port.getShort());
        short[] values = new short[3];
        port.getShorts(values, 1, 2);
        assertArrayEquals(new short[] {0, -2, 0x1234}, values);
        byte[] message = {9, 9, 9, 9, 9, 9};
        port.getBytes(message, 1, 5);
        assertArrayEquals(new byte[] {9, -2, -1, 0x34, 0x12, 0}, message);
    }

    @Test
    void aSensorPluggedOutFailsAtTheNextReadAndOnePluggedInAgainWorks() {
        brick.sensor(0).plugUart(30, "ev3-ultrasonic", "US-DIST-CM");
        UARTPort port = SensorPort.S1.open(UARTPort.class);
        port.setMode(0);
        brick.sensor(0).uart().shorts(0, 500);
        brick.sensor(0).unplug();
        var gone = assertThrows(DeviceException.class, port::getShort);
        assertEquals("Sensor changed unable to reset", gone.getMessage());
        brick.sensor(0).plugUart(30, "ev3-ultrasonic", "US-DIST-CM");
        port.setMode(0);
        assertEquals(500, port.getShort());
    }

    @Test
    void aClosedPortThrowsLikeTheOriginalsDeviceMemory() {
        brick.sensor(0).plugUart(30, "ev3-ultrasonic", "US-DIST-CM");
        UARTPort port = SensorPort.S1.open(UARTPort.class);
        port.setMode(0);
        port.close();
        assertThrows(IndexOutOfBoundsException.class, port::getShort);
    }

    @Test
    void rawLinesAreRefusedWithASentence() {
        UARTPort port = SensorPort.S1.open(UARTPort.class);
        assertThrows(UnsupportedOperationException.class, () -> port.setMode(UARTPort.UART_RAW_MODE));
        assertThrows(UnsupportedOperationException.class, () -> port.setBitRate(9600));
        assertThrows(UnsupportedOperationException.class, () -> port.rawRead(new byte[1], 0, 1));
        assertThrows(UnsupportedOperationException.class, () -> port.rawWrite(new byte[1], 0, 1));
    }

    @Test
    void aReadingIsShownWithItsUnit() {
        brick.sensor(0).plugUart(30, "ev3-ultrasonic", "US-DIST-CM", "US-DIST-IN", "US-LISTEN");
        UARTPort port = SensorPort.S1.open(UARTPort.class);
        assertEquals("S1", port.toString());
        port.setMode(0);
        brick.sensor(0).uart().shorts(0, 1234);
        assertEquals("123.4cm", port.toString());
        port.setMode(2);
        brick.sensor(0).uart().bytes(2, 1);
        assertEquals("1", port.toString());
    }

    @ParameterizedTest
    @CsvSource({"NONE,126,126", "UART,30,122", "UART,29,122", "ANALOG,16,121", "ANALOG,1,119", "ANALOG,2,119",
        "ANALOG,3,119", "ANALOG,4,118", "I2C,123,120"})
    void aSensorPortTellsWhatIsPluggedIn(Wiring wiring, int deviceType, int connection) {
        brick.sensor(3).plug(wiring, deviceType, "device");
        ConfigurationPort port = SensorPort.S4.open(ConfigurationPort.class);
        assertEquals(connection, port.getPortType());
        assertEquals(deviceType, port.getDeviceType());
    }
}
