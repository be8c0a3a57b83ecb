package lejos.hardware.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import brickless.hardware.SensorSocket.Wiring;
import lejos.hardware.AttachedBrick;
import lejos.hardware.port.I2CException;
import lejos.hardware.port.I2CPort;
import lejos.hardware.port.SensorPort;
import lejos.utility.SensorSelector;
import lejos.utility.SensorSelectorException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Expected numbers were measured with the published jar on a stub bus. */
class AccelerometersTest {
    @RegisterExtension
    final AttachedBrick brick = new AttachedBrick();

    private I2CPort bus(int... registers) {
        brick.sensor(0).plug(Wiring.I2C, 123, "own").i2c().registers(0x42, registers);
        return SensorPort.S1.open(I2CPort.class);
    }

    private static float[] sample(SensorMode mode) {
        float[] values = new float[mode.sampleSize()];
        mode.fetchSample(values, 0);
        return values;
    }

    @Test
    void hiTechnicCountsTwoHundredPerG() {
        HiTechnicAccelerometer sensor = new HiTechnicAccelerometer(bus(50, -50, -1, 0, 1, 3));
        assertThat(sensor.getAvailableModes()).containsExactly("Acceleration");
        assertThat(sample(sensor.getAccelerationMode())).containsExactly(9.80665f, -9.757617f, -0.04903325f);
    }

    @Test
    void mindsensorsCountsThousandPerGAndItsZPointsDown() {
        MindsensorsAccelerometer sensor = new MindsensorsAccelerometer(bus(0, 0, 0, 0xe8, 3, 0x18, 0xfc, 1, 0));
        assertThat(sensor.getAvailableModes()).containsExactly("Acceleration", "Tilt");
        assertThat(sample(sensor)).containsExactly(9.80665f, -9.80665f, -0.00980665f);
    }

    @ParameterizedTest
    @CsvSource({"0,-180", "1,-178.59375", "127,-1.40625", "128,0", "160,45", "255,178.59375"})
    void mindsensorsTiltIsLevelAt128(int count, float degrees) {
        MindsensorsAccelerometer sensor = new MindsensorsAccelerometer(bus(count, 128, 128));
        assertThat(sample(sensor.getTiltMode())).containsExactly(degrees, 0, 0);
    }

    @Test
    void aSilentBusFailsAtTheFirstReadNotBefore() {
        I2CPort empty = SensorPort.S1.open(I2CPort.class);
        I2CPort another = SensorPort.S2.open(I2CPort.class);
        assertThatThrownBy(() -> sample(new HiTechnicAccelerometer(empty))).isInstanceOf(I2CException.class);
        assertThatThrownBy(() -> sample(new MindsensorsAccelerometer(another))).isInstanceOf(I2CException.class);
    }

    @ParameterizedTest
    @CsvSource({"HiTechnc, 50, 9.80665", "mndsnsrs, 50, 0"})
    void theMakersNameChoosesTheDriver(String maker, int register, float first) throws SensorSelectorException {
        I2CPort port = bus(register, 0, 0, 0, 0, 0, 0, 0, 0);
        brick.sensor(0).i2c().text(0x08, maker);
        assertThat(sample(SensorSelector.createAccelerometer(port))[0]).isEqualTo(first);
    }

    @Test
    void unknownMakersHaveNoDriver() {
        I2CPort port = bus(0);
        brick.sensor(0).i2c().text(0x08, "LEGO");
        assertThatThrownBy(() -> SensorSelector.createAccelerometer(port)).isInstanceOf(SensorSelectorException.class)
                .hasMessage("No Such Sensor");
        assertThatThrownBy(() -> SensorSelector.createIRTransmitter(port)).isInstanceOf(SensorSelectorException.class);
    }
}
