package brickless.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;
import static org.assertj.core.data.Percentage.withPercentage;

import brickless.TestWorlds;
import brickless.physics.ArenaSettings;
import brickless.world.Pose2;
import brickless.world.RobotModel;
import brickless.world.SensorType;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Without {@code --ideal} errors are there, as large as documented, growing as documented, and the seed repeats them.
 */
class DefaultErrorsTest {
    private static final int METRE = 2046;
    private static final int QUARTER = 183;
    private static final double QUARTER_DEGREES = QUARTER * 56 / 114.0;

    /** Heading lost in each of eight squares of a metre, degrees. */
    private static double[] lostPerSquare(float turningSpeed, boolean ideal) {
        RobotBench bench = new RobotBench(TestWorlds.with(), TestWorlds.educator(), new Pose2(0, 0, 0),
                ArenaSettings.of(ideal));
        double[] lost = new double[8];
        double before = 0;
        for (int square = 0; square < lost.length; square++) {
            for (int side = 0; side < 4; side++) {
                bench.rotate(METRE, METRE, 360);
                bench.rotate(QUARTER, -QUARTER, turningSpeed);
            }
            double error = 4 * (square + 1) * QUARTER_DEGREES - bench.headingDegrees();
            lost[square] = error - before;
            before = error;
        }
        return lost;
    }

    @Test
    void fastTurnsSlipTheSameInEverySquare() {
        double[] lost = lostPerSquare(360, false);
        assertThat(Arrays.stream(lost).sum()).as("eight squares").isBetween(8.0, 11.0);
        assertThat(Arrays.stream(lost).boxed()).allSatisfy(degrees -> assertThat(degrees).isBetween(0.8, 1.6));
    }

    @Test
    void slowTurnsAndIdealTyresLoseNothing() {
        assertThat(Math.abs(Arrays.stream(lostPerSquare(180, false)).sum())).isLessThan(1);
        assertThat(Math.abs(Arrays.stream(lostPerSquare(360, true)).sum())).isLessThan(1);
    }

    @Test
    void metreAtMediumSpeedIsRightWithinAMillimetre() {
        RobotBench bench = RobotBench.real(TestWorlds.with(), TestWorlds.educator());
        bench.rotate(METRE, METRE, 360);
        assertThat(bench.robot.xMetres()).isCloseTo(1, offset(0.001));
    }

    private static SensorBench gyro(long seed) {
        SensorBench sensor = new SensorBench(TestWorlds.with(),
                SensorBench.front(SensorType.EV3_GYRO, 0.05), false, seed);
        sensor.port.uart().initialise(0);
        return sensor;
    }

    /** What the gyro adds in some quarter turns, slowly enough for it not to drift meanwhile. */
    private static double gyroError(long seed, int quarters) {
        SensorBench sensor = gyro(seed);
        for (int i = 0; i < quarters; i++) {
            sensor.bench.rotate(QUARTER, -QUARTER, 180);
        }
        return sensor.shorts(1)[0] - sensor.bench.headingDegrees();
    }

    @Test
    void gyroIsTwoOrThreeDegreesOffAfterAPairOfQuarterTurns() {
        double squares = 0;
        for (long seed = 0; seed < 60; seed++) {
            double error = gyroError(seed, 2);
            assertThat(error).as("seed %d", seed).isBetween(-4.6, 4.6);
            squares += error * error / 60;
        }
        assertThat(Math.sqrt(squares)).as("typical error").isBetween(1.8, 3.0);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void gyroErrorGrowsWithTheTurn(long seed) {
        double perTurn = gyroError(seed, 32) / 8;
        assertThat(Math.abs(perTurn)).isLessThan(7.3);
        assertThat(gyroError(seed, 8)).isCloseTo(2 * perTurn, offset(1.2));
    }

    @Test
    void gyroDriftsAtRestByItsLeftoverRate() {
        double most = 0;
        for (long seed = 0; seed < 15; seed++) {
            SensorBench sensor = gyro(seed);
            sensor.bench.runMillis(100_000);
            assertThat(sensor.shorts(1)[0]).as("seed %d", seed).isBetween(-2, 2);
            most = Math.max(most, Math.abs(sensor.shorts(1)[0]));
        }
        assertThat(most).isEqualTo(2);
    }

    @Test
    void echoesScatterByThreeMillimetres() {
        SensorBench sensor = new SensorBench(TestWorlds.with(TestWorlds.wall("wall", 1.06, -2, 1.2, 2)),
                SensorBench.front(SensorType.EV3_ULTRASONIC, 0.06), false, 7);
        sensor.port.uart().initialise(0);
        List<Integer> echoes = sensor.repeated(2000, 25);
        double mean = echoes.stream().mapToInt(mm -> mm).average().orElseThrow();
        double variance = echoes.stream().mapToDouble(mm -> (mm - mean) * (mm - mean)).average().orElseThrow();
        assertThat(mean).isCloseTo(1000, offset(0.5));
        assertThat(Math.sqrt(variance)).isCloseTo(3, withPercentage(5));
        assertThat(echoes).allSatisfy(mm -> assertThat(mm).isBetween(990, 1010));
    }

    /** Everything a robot with this sensor does and reads in five seconds. */
    private static List<Double> life(SensorType type, long seed, boolean ideal) {
        double height = type == SensorType.EV3_COLOR || type == SensorType.NXT_LIGHT ? 0.008 : 0.06;
        RobotModel model = TestWorlds.educator(SensorBench.front(type, height));
        RobotBench bench = new RobotBench(TestWorlds.world(List.of(TestWorlds.wall("wall", 0.8, -2, 0.9, 2)),
                List.of(SensorBench.paint(0x808080, -2, -2, 2, 2))), model, new Pose2(0, 0, 0), ArenaSettings.of(ideal),
                seed);
        if (type.name().startsWith("EV3")) {
            bench.devices.sensor(0).uart().initialise(0);
        }
        List<Double> values = new ArrayList<>();
        bench.drive(60, 45);
        IntStream.range(0, 250).forEach(i -> {
            bench.runMillis(20);
            for (double value : bench.devices.sensor(0).reading(bench.processor.nowNanos())) {
                values.add(value);
            }
            values.add(bench.robot.xMetres());
            values.add(bench.headingDegrees());
        });
        return values;
    }

    @ParameterizedTest
    @EnumSource(value = SensorType.class,
            names = {"EV3_ULTRASONIC", "EV3_COLOR", "EV3_GYRO", "EV3_INFRARED", "NXT_LIGHT",
        "NXT_SOUND", "NXT_ULTRASONIC"})
    void sameSeedRepeatsExactlyAnotherDoesNotAndIdealKnowsNone(SensorType type) {
        assertThat(life(type, 5, false)).isEqualTo(life(type, 5, false)).isNotEqualTo(life(type, 6, false));
        assertThat(life(type, 5, true)).isEqualTo(life(type, 6, true));
    }
}
