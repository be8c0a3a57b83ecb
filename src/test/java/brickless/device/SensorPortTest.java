package brickless.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import brickless.TestWorlds;
import brickless.hardware.SensorSocket.Wiring;
import brickless.world.Point2;
import brickless.world.RobotModel.SensorMount;
import brickless.world.SensorType;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The port itself, the touch sensors and the gyro. */
class SensorPortTest {
    private static final double PRESSED_VOLTS = 2.5;
    private static final int ANGLE_AND_RATE = 3;

    private static SensorBench touch(SensorType type) {
        SensorMount mount = new SensorMount("bumper", 0, type, new Point2(0.06, 0), 0, 0.03,
                TestWorlds.box(0.05, -0.05, 0.06, 0.05), Optional.empty());
        return new SensorBench(TestWorlds.with(TestWorlds.wall("wall", 0.2, -1, 0.25, 1)), mount, false);
    }

    @Test
    void bumperIsPressedByTheWallAndFreeAfterBackingUp() {
        SensorBench sensor = touch(SensorType.EV3_TOUCH);
        assertThat(sensor.port.analog().pin6Volts()).isLessThan(PRESSED_VOLTS);
        sensor.bench.drive(40, 40);
        sensor.bench.runMillis(1500);
        assertThat(sensor.port.analog().pin6Volts()).isGreaterThan(PRESSED_VOLTS);
        sensor.bench.drive(0, 0);
        sensor.bench.runMillis(500);
        assertThat(sensor.port.analog().pin6Volts()).as("still against the wall").isGreaterThan(PRESSED_VOLTS);
        sensor.bench.drive(-40, -40);
        sensor.bench.runMillis(300);
        assertThat(sensor.port.analog().pin6Volts()).isLessThan(PRESSED_VOLTS);
    }

    @Test
    void handPressesTheTouchSensor() {
        SensorBench sensor = touch(SensorType.EV3_TOUCH);
        sensor.port.push(true);
        assertThat(sensor.port.analog().pin6Volts()).isGreaterThan(PRESSED_VOLTS);
        sensor.port.push(false);
        assertThat(sensor.port.analog().pin6Volts()).isLessThan(PRESSED_VOLTS);
    }

    @Test
    void nxtTouchSensorPullsPinOneDown() {
        SensorBench sensor = touch(SensorType.NXT_TOUCH);
        assertThat(sensor.port.analog().pin1Volts()).isGreaterThan(PRESSED_VOLTS);
        sensor.port.push(true);
        assertThat(sensor.port.analog().pin1Volts()).isLessThan(PRESSED_VOLTS);
    }

    @Test
    void chassisBesideTheBumperDoesNotPressIt() {
        SensorMount mount = new SensorMount("bumper", 0, SensorType.EV3_TOUCH, new Point2(0.06, 0), 0, 0.03,
                TestWorlds.box(0.02, -0.02, 0.04, 0.02),
                Optional.empty());
        SensorBench sensor = new SensorBench(TestWorlds.with(TestWorlds.wall("wall", 0.2, -1, 0.25, 1)), mount, false);
        sensor.bench.drive(40, 40);
        sensor.bench.runMillis(1500);
        assertThat(sensor.port.analog().pin6Volts()).isLessThan(PRESSED_VOLTS);
    }

    @ParameterizedTest
    @CsvSource({"EV3_TOUCH,ANALOG,16", "EV3_COLOR,UART,29", "EV3_ULTRASONIC,UART,30", "EV3_GYRO,UART,32",
            "EV3_INFRARED,UART,33", "NXT_TOUCH,ANALOG,1",
        "NXT_LIGHT,ANALOG,2", "NXT_SOUND,ANALOG,3", "NXT_COLOR,ANALOG,4", "NXT_ULTRASONIC,I2C,123"})
    void devicesTellWhatTheyAre(SensorType type, Wiring wiring, int number) {
        SensorBench sensor = SensorBench.of(type);
        assertThat(sensor.port.wiring()).isEqualTo(wiring);
        assertThat(sensor.port.deviceType()).isEqualTo(number);
        assertThat(sensor.port.connected()).isEqualTo(type.attribute());
    }

    @Test
    void emptyPortAnswersLikeNothing() {
        SensorBench sensor = SensorBench.of(SensorType.EV3_TOUCH);
        sensor.port.plug(null);
        assertThat(sensor.port.wiring()).isEqualTo(Wiring.NONE);
        assertThat(sensor.port.deviceType()).isEqualTo(126);
        assertThat(sensor.port.analog().pin1Volts()).isEqualTo(5);
        assertThat(sensor.port.analog().pin6Volts()).isZero();
        assertThat(sensor.port.uart().initialise(0)).isFalse();
        assertThat(sensor.port.uart().read(new byte[4], 0, 4)).isZero();
        assertThat(sensor.port.uart().modeName(0)).isEqualTo("Unknown");
        assertThat(sensor.port.reading(0)).isEmpty();
    }

    @Test
    void sensorPluggedAtRunTimeWorks() {
        SensorBench sensor = SensorBench.of(SensorType.EV3_TOUCH, TestWorlds.wall("wall", 0.56, -1, 0.6, 1));
        sensor.port.plug(SensorBench.front(SensorType.EV3_ULTRASONIC, 0.06));
        assertThat(sensor.port.uart().initialise(0)).isTrue();
        assertThat(sensor.shorts(1)[0]).isCloseTo(500, offset(10));
    }

    @Test
    void serialDeviceIsSilentUntilInitialisedAndAfterReset() {
        SensorBench sensor = SensorBench.of(SensorType.EV3_COLOR);
        assertThat(sensor.port.uart().read(new byte[2], 0, 2)).isZero();
        sensor.port.uart().initialise(0);
        assertThat(sensor.port.uart().read(new byte[2], 0, 2)).isEqualTo(1);
        sensor.port.uart().reset();
        assertThat(sensor.port.uart().read(new byte[2], 0, 2)).isZero();
    }

    @Test
    void unknownModeIsRefused() {
        SensorBench sensor = SensorBench.of(SensorType.EV3_COLOR);
        assertThat(sensor.port.uart().initialise(9)).isFalse();
        assertThat(sensor.port.uart().setMode(-1)).isFalse();
        assertThat(sensor.port.uart().modeName(4)).isEqualTo("RGB-RAW");
    }

    @Test
    void modeSwitchBlocksForTensOfMilliseconds() {
        SensorBench sensor = new SensorBench(TestWorlds.with(), SensorBench.front(SensorType.EV3_COLOR, 0.008), false);
        sensor.port.uart().initialise(0);
        long before = sensor.bench.processor.nowNanos();
        sensor.port.uart().setMode(4);
        long switched = sensor.bench.processor.nowNanos();
        sensor.port.uart().setMode(4);
        assertThat(switched - before).isBetween(20_000_000L, 50_000_000L);
        assertThat(sensor.bench.processor.nowNanos() - switched).isLessThan(1_000_000L);
    }

    @Test
    void everyReadCharges() {
        SensorBench sensor = SensorBench.of(SensorType.EV3_TOUCH);
        long before = sensor.bench.processor.nowNanos();
        sensor.port.analog().pin6Volts();
        assertThat(sensor.bench.processor.nowNanos() - before).isEqualTo(200_000);
    }

    private static SensorBench gyro(boolean ideal) {
        SensorBench sensor = new SensorBench(TestWorlds.with(), SensorBench.front(SensorType.EV3_GYRO, 0.05), ideal);
        sensor.port.uart().initialise(ANGLE_AND_RATE);
        return sensor;
    }

    @Test
    void gyroCountsClockwisePositive() {
        SensorBench sensor = gyro(true);
        sensor.bench.rotate(183, -183, 180);
        sensor.bench.runMillis(500);
        int[] values = sensor.shorts(2);
        assertThat(values[0]).isCloseTo((int) Math.round(sensor.bench.headingDegrees()), offset(1));
        assertThat(values[0]).isBetween(85, 95);
        assertThat(values[1]).isZero();
    }

    @Test
    void gyroRateIsTheYawRate() {
        SensorBench sensor = gyro(true);
        sensor.bench.drive(-30, 30);
        sensor.bench.runMillis(1000);
        int rate = sensor.shorts(2)[1];
        assertThat(rate).isNegative();
        assertThat((double) rate).isCloseTo(Math.toDegrees(sensor.bench.robot.yawRateRadiansPerSecond()), offset(3.0));
    }

    @Test
    void gyroRateSaturatesAt440() {
        SensorBench sensor = gyro(true);
        sensor.bench.devices.battery().setOpenVolts(12);
        sensor.bench.drive(100, -100);
        sensor.bench.runMillis(1000);
        assertThat(Math.toDegrees(sensor.bench.robot.yawRateRadiansPerSecond())).isGreaterThan(440);
        assertThat(sensor.shorts(2)[1]).isEqualTo(440);
    }

    @Test
    void gyroAngleEndsAt32767() {
        SensorBench sensor = gyro(true);
        sensor.bench.devices.battery().setOpenVolts(9);
        sensor.bench.drive(90, -90);
        sensor.bench.runMillis(100_000);
        assertThat(sensor.bench.headingDegrees()).isGreaterThan(33_000);
        assertThat(sensor.shorts(2)[0]).isEqualTo(32_767);
    }

    @Test
    void realGyroIsAFewDegreesOffButNotMore() {
        SensorBench sensor = gyro(false);
        for (int i = 0; i < 4; i++) {
            sensor.bench.rotate(183, -183, 180);
        }
        double error = sensor.shorts(2)[0] - sensor.bench.headingDegrees();
        assertThat(error).isBetween(-9.0, 9.0);
    }

    @Test
    void resetWhileTurningMakesTheAngleDrift() {
        SensorBench sensor = gyro(false);
        sensor.bench.drive(20, -20);
        sensor.bench.runMillis(500);
        sensor.port.uart().setMode(1);
        sensor.port.uart().setMode(ANGLE_AND_RATE);
        sensor.bench.drive(0, 0);
        sensor.bench.runMillis(1000);
        int first = sensor.shorts(2)[0];
        sensor.bench.runMillis(2000);
        assertThat(sensor.shorts(2)[0]).isLessThan(first - 50);
    }

    @Test
    void gyroAtRestDriftsLittle() {
        SensorBench sensor = gyro(false);
        sensor.bench.runMillis(20_000);
        assertThat(sensor.shorts(2)[0]).isBetween(-1, 1);
        assertThat(sensor.port.reading(sensor.bench.processor.nowNanos())).hasSize(2);
    }
}
