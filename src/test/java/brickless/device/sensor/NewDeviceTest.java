package brickless.device.sensor;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.TestWorlds;
import brickless.device.RobotBench;
import brickless.hardware.I2cChannel.Status;
import brickless.hardware.SensorSocket.Wiring;
import brickless.physics.ArenaSettings;
import brickless.units.Angles;
import brickless.world.Point2;
import brickless.world.Pose2;
import brickless.world.RobotModel.SensorMount;
import brickless.world.SensorType;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** A new device is one class: here a compass with a register for its bearing and one that sets its zero. */
class NewDeviceTest {
    private static final int COMPASS_ADDRESS = 0x14;

    private static final class Compass extends RegisterSensor {
        private static final int ZERO = 0x41;
        private static final int BEARING = 0x42;
        private double zero;

        Compass(SensorSite site) {
            super(site, COMPASS_ADDRESS, "V2.0", "MAKER OF THINGS", "Compass");
        }

        @Override
        boolean writable(int register) {
            return register == ZERO;
        }

        @Override
        void written(int register, long nowNanos) {
            zero = degrees();
        }

        @Override
        void aboutToRead(long nowNanos) {
            setRegister(BEARING, (int) Math.round((degrees() - zero) / 2));
        }

        private double degrees() {
            return Angles.degreesFromRadians(aim().headingRadians);
        }

        @Override
        double[] reading(long nowNanos) {
            return new double[] {degrees() - zero};
        }
    }

    private final SensorPortDevice port = port();

    private static SensorPortDevice port() {
        RobotBench bench = new RobotBench(TestWorlds.with(), TestWorlds.educator(), new Pose2(0, 0,
                Angles.radiansFromDegrees(90)),
                ArenaSettings.of(true));
        SensorMount mount = new SensorMount("compass", 1, SensorType.NXT_ULTRASONIC, new Point2(0, 0), 0, 0.06,
                List.of(),
                Optional.empty());
        bench.devices.sensor(1).plug(mount, Compass::new);
        return bench.devices.sensor(1);
    }

    private byte[] read(int register, int length) {
        byte[] bytes = new byte[length];
        Status status = port.i2c().transaction(COMPASS_ADDRESS, new byte[] {(byte) register}, 0, 1, bytes, 0, length);
        assertThat(status).isEqualTo(Status.OK);
        return bytes;
    }

    @Test
    void itsRegistersAreReadAndWritten() {
        assertThat(read(Compass.BEARING, 1)).containsExactly(45);
        port.i2c().transaction(COMPASS_ADDRESS, new byte[] {Compass.ZERO, 1}, 0, 2, null, 0, 0);
        assertThat(read(Compass.BEARING, 1)).containsExactly(0);
    }

    @Test
    void itsTextsAreEightCharactersLong() {
        assertThat(read(0x08, 8)).asString().isEqualTo("MAKER OF");
        assertThat(read(0x10, 7)).asString().isEqualTo("Compass");
        assertThat(port.wiring()).isEqualTo(Wiring.I2C);
    }

    @Test
    void otherAddressesGetNoAnswerAndOtherRegistersKeepTheirValues() {
        assertThat(port.i2c().transaction(0x02, new byte[] {0}, 0, 1, new byte[1], 0, 1)).isEqualTo(Status.NO_ANSWER);
        port.i2c().transaction(COMPASS_ADDRESS, new byte[] {0x08, 'x'}, 0, 2, null, 0, 0);
        assertThat(read(0x08, 1)).containsExactly('M');
    }

    @Test
    void thereIsNothingBehindTheLastRegister() {
        assertThat(read(0xff, 2)).containsExactly(0, 0);
    }
}
