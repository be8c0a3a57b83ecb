package lejos.hardware.sensor;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import brickless.hardware.I2cChannel.Status;
import brickless.hardware.SensorSocket.Wiring;
import java.util.List;
import lejos.hardware.AttachedBrick;
import lejos.hardware.port.I2CException;
import lejos.hardware.port.I2CPort;
import lejos.hardware.port.PortException;
import lejos.hardware.port.SensorPort;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class I2CSensorTest {
    private static final Status LOST = Status.NO_ANSWER;

    @RegisterExtension
    final AttachedBrick brick = new AttachedBrick();

    private I2CSensor sensor() {
        brick.sensor(0).plug(Wiring.I2C, 123, "own");
        I2CSensor sensor = new I2CSensor(SensorPort.S1);
        brick.sensor(0).log().clear();
        return sensor;
    }

    @ParameterizedTest
    @CsvSource({"10,configure 10kHz", "11,configure 10kHz 9V", "18,configure 100kHz", "19,configure 100kHz 9V"})
    void theTypeSelectsSpeedAndVoltage(int type, String command) {
        I2CSensor sensor = new I2CSensor(SensorPort.S1, 0x10, type);
        assertEquals(List.of("expect I2CSensor", command), brick.sensor(0).log());
        assertEquals(0x10, sensor.getAddress());
    }

    @Test
    void otherTypesAreRefusedAndThePortIsFree() {
        var refusal = assertThrows(IllegalArgumentException.class, () -> new I2CSensor(SensorPort.S1, 2, 9));
        assertEquals("Invalid sensor mode", refusal.getMessage());
        new I2CSensor(SensorPort.S1, 2);
    }

    @Test
    void failuresOfABusNeedNotBeCaught() {
        I2CException failure = new I2CException("I2C I/O error");
        assertInstanceOf(PortException.class, failure);
        assertInstanceOf(RuntimeException.class, new PortException("no", failure));
        assertEquals("I2C I/O error", failure.getMessage());
    }

    @Test
    void defaultsAreAddressTwoAndThreeTries() {
        assertEquals(2, sensor().getAddress());
        I2CPort port = SensorPort.S2.open(I2CPort.class);
        I2CSensor onOpenPort = new I2CSensor(port);
        assertEquals(2, onOpenPort.getAddress());
        assertEquals(3, onOpenPort.getRetryCount());
        assertSame(port, onOpenPort.getPort());
    }

    @Test
    void registersAreWrittenAndRead() {
        I2CSensor sensor = sensor();
        sensor.sendData(0x41, (byte) 2);
        sensor.sendData(0x50, new byte[] {7, 8, 9}, 1, 2);
        byte[] values = new byte[3];
        sensor.getData(0x50, values, 1, 2);
        assertArrayEquals(new byte[] {0, 8, 9}, values);
        sensor.getData(0x41, values, 1);
        assertArrayEquals(new byte[] {2, 8, 9}, values);
        assertEquals(List.of("write 41 02", "write 50 08 09", "read 50", "read 41"), brick.sensor(0).log());
    }

    @ParameterizedTest
    @CsvSource({"1,0,true", "1,1,false", "3,2,true", "3,3,false", "5,4,true", "5,5,false"})
    void failedTransactionsAreRepeated(int tries, int failures, boolean succeeds) {
        I2CSensor sensor = sensor();
        sensor.setRetryCount(tries);
        for (int i = 0; i < failures; i++) {
            brick.sensor(0).i2c().troubles(i % 2 == 0 ? LOST : Status.BUSY);
        }
        if (succeeds) {
            sensor.sendData(0x41, (byte) 1);
        } else {
            var failure = assertThrows(I2CException.class, () -> sensor.sendData(0x41, (byte) 1));
            assertEquals(failures % 2 == 1 ? "I2C I/O error" : "I2C Bus busy", failure.getMessage());
        }
        assertEquals(Math.min(tries, failures + 1), brick.sensor(0).log().size());
    }

    @ParameterizedTest
    @CsvSource({"0", "-1"})
    void atLeastOneTryIsNeeded(int tries) {
        I2CSensor sensor = sensor();
        assertThrows(IllegalArgumentException.class, () -> sensor.setRetryCount(tries));
        assertEquals(3, sensor.getRetryCount());
    }

    @Test
    void thirtyOneBytesCanBeSentThirtyTwoCannot() {
        I2CSensor sensor = sensor();
        sensor.sendData(0, new byte[31], 31);
        var refusal = assertThrows(IllegalArgumentException.class, () -> sensor.sendData(0, new byte[32], 32));
        assertEquals("Invalid buffer length", refusal.getMessage());
    }

    @Test
    void textsEndAtNulAndAreTrimmed() {
        I2CSensor sensor = sensor();
        brick.sensor(0).i2c().text(0x00, "V1.0\0xyz");
        brick.sensor(0).i2c().text(0x08, "LEGO    ");
        brick.sensor(0).i2c().text(0x10, "Sonar123more");
        assertEquals("V1.0", sensor.getVersion());
        assertEquals("LEGO", sensor.getVendorID());
        assertEquals("Sonar123", sensor.getProductID());
    }

    @Test
    void textsAreEmptyWhenNothingAnswers() {
        I2CSensor sensor = sensor();
        brick.sensor(0).unplug();
        assertEquals("", sensor.getVersion());
        assertEquals("", sensor.getVendorID());
        assertEquals("", sensor.getProductID());
    }

    @Test
    @SuppressWarnings("deprecation")
    void theOldAddressIsCheckedInPlaceOfTheNewOne() {
        I2CSensor sensor = sensor();
        sensor.setAddress(3);
        assertEquals(3, sensor.getAddress());
        assertThrows(IllegalArgumentException.class, () -> sensor.setAddress(4));
    }

    @Test
    void anotherAddressGetsNoAnswer() {
        brick.sensor(0).plug(Wiring.I2C, 123, "own");
        I2CSensor sensor = new I2CSensor(SensorPort.S1, 0x12);
        assertThrows(I2CException.class, () -> sensor.getData(0, new byte[1], 1));
    }
}
