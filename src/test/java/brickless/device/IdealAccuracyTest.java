package brickless.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import brickless.TestWorlds;
import brickless.hardware.MoveRequest;
import brickless.physics.ArenaSettings;
import brickless.world.Obstacle;
import brickless.world.Pose2;
import brickless.world.RobotModel;
import brickless.world.SensorType;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/**
 * What must hold without noise, latency and slip: one percent of a metre, one degree of a turn, a centimetre of an
 * echo. Cases are decoded from their number.
 */
class IdealAccuracyTest {
    private static final float[] SPEEDS = {60, 180, 360, 540, 700};
    private static final double[] DIAMETERS = {0.0432, 0.056};
    private static final double[] TRACKS = {0.114, 0.145, 0.18};
    private static final int[] ACCELERATIONS = {500, 1500, 6000};
    private static final int CASES = SPEEDS.length * DIAMETERS.length * TRACKS.length * ACCELERATIONS.length * 2;

    /** One robot and one way of moving. */
    private record Case(float speed, double diameter, double track, int acceleration, int sign) {
        static Case of(int index) {
            return new Case(SPEEDS[index % 5], DIAMETERS[index / 5 % 2], TRACKS[index / 10 % 3],
                    ACCELERATIONS[index / 30 % 3], index / 90 == 0 ? 1 : -1);
        }

        RobotBench bench(double heading) {
            RobotModel model = TestWorlds.robot(List.of(TestWorlds.wheel("left", 1, -track / 2, diameter),
                    TestWorlds.wheel("right", 2, track / 2, diameter)), List.of());
            return new RobotBench(TestWorlds.with(), model, new Pose2(0, 0, heading), ArenaSettings.of(true));
        }

        /** Turns the wheels as a pilot does: both at once, each by whole degrees. */
        void move(RobotBench bench, long left, long right) {
            bench.devices.moveTogether(new int[] {1, 2}, new MoveRequest[] {
                new MoveRequest(speed, acceleration, (int) left, true),
                new MoveRequest(speed, acceleration, (int) right, true)});
            bench.devices.motor(RobotBench.LEFT).awaitStandstill();
            bench.devices.motor(RobotBench.RIGHT).awaitStandstill();
        }
    }

    @Test
    void metreEndsWithinOnePercentAndOneDegree() {
        for (int index = 0; index < CASES; index++) {
            Case one = Case.of(index);
            double heading = 0.07 * index;
            RobotBench bench = one.bench(heading);
            long degrees = one.sign * Math.round(360 / (Math.PI * one.diameter));
            one.move(bench, degrees, degrees);
            double x = bench.robot.xMetres() - one.sign * Math.cos(heading);
            double y = bench.robot.yMetres() - one.sign * Math.sin(heading);
            assertThat(Math.hypot(x, y)).as("%d: %s, metres", index, one).isLessThan(0.01);
            assertThat(bench.headingDegrees()).as("%d: %s", index, one)
                    .isCloseTo(Math.toDegrees(heading), offset(1.0));
        }
    }

    @Test
    void fullTurnEndsWithinOneDegree() {
        for (int index = 0; index < CASES; index++) {
            Case one = Case.of(index);
            RobotBench bench = one.bench(0);
            long degrees = one.sign * Math.round(360 * one.track / one.diameter);
            one.move(bench, degrees, -degrees);
            assertThat(bench.headingDegrees()).as("%d: %s", index, one).isCloseTo(360 * one.sign, offset(1.0));
            assertThat(Math.hypot(bench.robot.xMetres(), bench.robot.yMetres())).as("%d: %s, metres", index, one)
                    .isLessThan(0.01);
        }
    }

    /** A room of 3 m by 2 m around the origin, its walls outside. */
    private static Obstacle[] room() {
        return new Obstacle[] {TestWorlds.wall("n", -1.6, -1.1, 1.6, -1), TestWorlds.wall("s", -1.6, 1, 1.6, 1.1),
            TestWorlds.wall("w", -1.6, -1, -1.5, 1), TestWorlds.wall("e", 1.5, -1, 1.6, 1)};
    }

    /** The nearest echo in the cone of the beam, by scanning it in steps of a twentieth of a degree. */
    private static double echoMetres(double eyeX, double eyeY, double heading) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int i = -300; i <= 300; i++) {
            double direction = heading + Math.toRadians(i / 20.0);
            double cos = Math.cos(direction);
            double sin = Math.sin(direction);
            double toSide = (cos > 0 ? 1.5 - eyeX : -1.5 - eyeX) / cos;
            double toEnd = (sin > 0 ? 1 - eyeY : -1 - eyeY) / sin;
            double incidence = Math.acos(Math.abs(toSide < toEnd ? cos : sin));
            double distance = Math.min(toSide, toEnd);
            if (incidence <= Math.toRadians(45) && distance <= 2.55) {
                nearest = Math.min(nearest, distance);
            }
        }
        return nearest;
    }

    @Test
    void echoesAreWithinACentimetreOfGeometry() {
        SensorBench sensor = SensorBench.of(SensorType.EV3_ULTRASONIC, room());
        sensor.port.uart().initialise(0);
        for (int index = 0; index < 7 * 5 * 180; index++) {
            double x = -1.2 + 0.4 * (index % 7);
            double y = -0.6 + 0.3 * (index / 7 % 5);
            double heading = Math.toRadians(2.0 * (index / 35) + 0.3);
            sensor.bench.arena.move(sensor.bench.robot,
                    new Pose2(x - 0.06 * Math.cos(heading), y - 0.06 * Math.sin(heading), heading));
            sensor.bench.runMillis(2);
            double expected = Math.min(2.55, echoMetres(x, y, heading)) * 1000;
            assertThat((double) sensor.shorts(1)[0]).as("%d: (%.1f, %.1f), heading %.3f", index, x, y, heading)
                    .isCloseTo(expected, offset(10.0));
        }
    }

    @Test
    void seedsChangeNothing() {
        assertThat(readings(1)).isEqualTo(readings(2));
    }

    private static List<Integer> readings(long seed) {
        RobotBench bench = new RobotBench(TestWorlds.with(room()),
                TestWorlds.educator(SensorBench.front(SensorType.EV3_ULTRASONIC, 0.06)), new Pose2(0, 0, 0),
                ArenaSettings.of(true), seed);
        bench.devices.sensor(0).uart().initialise(0);
        byte[] bytes = new byte[2];
        bench.drive(50, 40);
        return IntStream.range(0, 100).mapToObj(i -> {
            bench.runMillis(10);
            bench.devices.sensor(0).uart().read(bytes, 0, 2);
            return bytes[0] & 0xff | bytes[1] << 8;
        }).toList();
    }
}
