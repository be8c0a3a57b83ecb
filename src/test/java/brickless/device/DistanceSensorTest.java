package brickless.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import brickless.TestWorlds;
import brickless.hardware.I2cChannel.Status;
import brickless.physics.Arena;
import brickless.physics.ArenaSettings;
import brickless.physics.Entrant;
import brickless.world.Beacon;
import brickless.world.Obstacle;
import brickless.world.Point2;
import brickless.world.Pose2;
import brickless.world.Rgb;
import brickless.world.SensorType;
import brickless.world.World;
import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Ultrasonic and infrared sensors against geometry. */
class DistanceSensorTest {
    private static final int NOTHING = 2550;

    private static Obstacle wallAt(double metresFromSensor) {
        return TestWorlds.wall("wall", 0.06 + metresFromSensor, -2, 0.2 + metresFromSensor, 2);
    }

    private static int millimetres(SensorBench sensor) {
        if (!sensor.port.uart().initialise(0)) {
            throw new IllegalStateException("no sensor");
        }
        sensor.bench.runMillis(100);
        return sensor.shorts(1)[0];
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.05, 0.2, 0.5, 1.0, 1.5})
    void headOnWallIsMeasuredWithinACentimetre(double metres) {
        assertThat(millimetres(SensorBench.of(SensorType.EV3_ULTRASONIC, wallAt(metres))))
                .isCloseTo((int) (metres * 1000), offset(10));
    }

    @Test
    void nothingReads2550() {
        assertThat(millimetres(SensorBench.of(SensorType.EV3_ULTRASONIC))).isEqualTo(NOTHING);
    }

    @Test
    void tooNearReadsTheShortestDistance() {
        assertThat(millimetres(SensorBench.of(SensorType.EV3_ULTRASONIC, wallAt(0.005)))).isEqualTo(30);
    }

    @Test
    void slantedWallIsHeardUpToTheLimitOfIncidenceOnly() {
        assertThat(facingWall(0.5)).isBetween(400, 600);
        assertThat(facingWall(1.2)).isEqualTo(NOTHING);
        assertThat(facingWall(-1.2)).isEqualTo(NOTHING);
    }

    private static int facingWall(double heading) {
        SensorBench sensor = SensorBench.of(SensorType.EV3_ULTRASONIC, wallAt(0.45));
        sensor.bench.arena.move(sensor.bench.robot, new Pose2(0, 0, heading));
        return millimetres(sensor);
    }

    @Test
    void thingsBesideTheBeamAreNotHeard() {
        assertThat(millimetres(SensorBench.of(SensorType.EV3_ULTRASONIC, TestWorlds.crate("c", 0.56, 0.1, 0.1, 1))))
                .isLessThan(NOTHING);
        assertThat(millimetres(SensorBench.of(SensorType.EV3_ULTRASONIC, TestWorlds.crate("c", 0.56, 0.3, 0.1, 1))))
                .isEqualTo(NOTHING);
    }

    @Test
    void absorbingAndLowObstaclesAreNotHeard() {
        List<Point2> box = TestWorlds.box(0.3, -0.2, 0.4, 0.2);
        Rgb colour = new Rgb(0, 0, 0);
        Obstacle curtain = new Obstacle("curtain", List.of(box), false, 0, 0.1, 0.5, true, colour);
        Obstacle kerb = new Obstacle("kerb", List.of(box), false, 0, 0.02, 0.5, false, colour);
        assertThat(millimetres(SensorBench.of(SensorType.EV3_ULTRASONIC, curtain))).isEqualTo(NOTHING);
        assertThat(millimetres(SensorBench.of(SensorType.EV3_ULTRASONIC, kerb))).isEqualTo(NOTHING);
    }

    /** A chair leg of 2 cm anywhere in the beam, near and far, for every direction of the sensor. */
    @ParameterizedTest
    @ValueSource(doubles = {0.2, 0.35, 0.6, 1.0, 1.5, 2.0})
    void slenderPostIsNeverMissed(double metres) {
        Obstacle post = TestWorlds.wall("post", 0.05 + metres, -0.01, 0.07 + metres, 0.01);
        SensorBench sensor = SensorBench.of(SensorType.EV3_ULTRASONIC, post);
        sensor.port.uart().initialise(0);
        for (int tenths = -140; tenths <= 140; tenths += 4) {
            double heading = Math.toRadians(tenths / 10.0);
            sensor.bench.arena.move(sensor.bench.robot, facingFrom(heading));
            sensor.bench.runMillis(4);
            assertThat(sensor.shorts(1)[0]).as("%d tenths of a degree", tenths)
                    .isCloseTo((int) (metres * 1000 - 10), offset(5));
        }
    }

    /** The pose in which the sensor, 60 mm ahead of the axle, stands at (0.06, 0) and looks along a heading. */
    private static Pose2 facingFrom(double heading) {
        return new Pose2(0.06 - 0.06 * Math.cos(heading), -0.06 * Math.sin(heading), heading);
    }

    @Test
    void slenderPostShowsInInfraredProximityToo() {
        Obstacle post = TestWorlds.wall("post", 0.05 + 0.35, -0.01, 0.07 + 0.35, 0.01);
        SensorBench sensor = SensorBench.of(SensorType.EV3_INFRARED, post);
        sensor.port.uart().initialise(0);
        for (int tenths = -90; tenths <= 90; tenths += 6) {
            sensor.bench.arena.move(sensor.bench.robot, facingFrom(Math.toRadians(tenths / 10.0)));
            sensor.bench.runMillis(4);
            assertThat((int) sensor.bytes(1)[0]).as("%d tenths of a degree", tenths).isBetween(48, 56);
        }
    }

    @Test
    void inchesAreTenths() {
        SensorBench sensor = SensorBench.of(SensorType.EV3_ULTRASONIC, wallAt(0.508));
        sensor.port.uart().initialise(1);
        sensor.bench.runMillis(60);
        assertThat(sensor.shorts(1)[0]).isCloseTo(200, offset(4));
    }

    @Test
    void noisyDistanceStaysWithinACentimetreAndChangesOncePerPing() {
        SensorBench sensor = new SensorBench(TestWorlds.with(wallAt(0.8)),
                SensorBench.front(SensorType.EV3_ULTRASONIC, 0.06), false);
        sensor.port.uart().initialise(0);
        sensor.bench.runMillis(200);
        List<Integer> values = sensor.repeated(1000, 1);
        Set<Integer> different = new HashSet<>(values);
        assertThat(different).hasSizeGreaterThan(5);
        assertThat(values).allSatisfy(v -> assertThat(v).isBetween(785, 815));
        int changes = 0;
        for (int i = 1; i < values.size(); i++) {
            changes += values.get(i).equals(values.get(i - 1)) ? 0 : 1;
        }
        assertThat(changes).isLessThanOrEqualTo(50);
    }

    @Test
    void readingMoreOftenDoesNotChangeValues() {
        SensorBench often = new SensorBench(TestWorlds.with(wallAt(0.8)),
                SensorBench.front(SensorType.EV3_ULTRASONIC, 0.06), false);
        SensorBench seldom = new SensorBench(TestWorlds.with(wallAt(0.8)),
                SensorBench.front(SensorType.EV3_ULTRASONIC, 0.06), false);
        often.port.uart().initialise(0);
        seldom.port.uart().initialise(0);
        often.repeated(500, 0);
        often.bench.runMillis(400);
        seldom.bench.runMillis(500);
        assertThat(often.bench.processor.nowNanos()).isEqualTo(seldom.bench.processor.nowNanos());
        assertThat(often.shorts(1)).isEqualTo(seldom.shorts(1));
    }

    @Test
    void listeningSensorHearsAnotherRobot() {
        World world = TestWorlds.with();
        Arena arena = new Arena(world, List.of(
                new Entrant("a", TestWorlds.educator(SensorBench.front(SensorType.EV3_ULTRASONIC, 0.06)),
                        new Pose2(0, 0, 0)),
                new Entrant("b", TestWorlds.educator(SensorBench.front(SensorType.EV3_ULTRASONIC, 0.06)),
                        new Pose2(1, 0, Math.PI))),
                ArenaSettings.of(true));
        FakeProcessor processor = new FakeProcessor(arena.stepNanos(), now -> arena.step());
        RobotDevices a = RobotDevices.of(arena, arena.robots().get(0), processor, 1, true);
        RobotDevices b = RobotDevices.of(arena, arena.robots().get(1), processor, 1, true);
        byte[] heard = new byte[1];
        a.sensor(0).uart().initialise(2);
        a.sensor(0).uart().read(heard, 0, 1);
        assertThat(heard[0]).isZero();
        b.sensor(0).uart().initialise(0);
        a.sensor(0).uart().read(heard, 0, 1);
        assertThat(heard[0]).isEqualTo((byte) 1);
    }

    @Test
    void nxtUltrasonicTellsCentimetresInARegister() {
        SensorBench sensor = SensorBench.of(SensorType.NXT_ULTRASONIC, wallAt(0.42));
        byte[] data = new byte[1];
        long before = sensor.bench.processor.nowNanos();
        assertThat(sensor.port.i2c().transaction(2, new byte[] {0x41, 2}, 0, 2, null, 0, 0)).isEqualTo(Status.OK);
        assertThat(sensor.bench.processor.nowNanos() - before).isGreaterThanOrEqualTo(5_000_000);
        sensor.bench.runMillis(60);
        assertThat(sensor.port.i2c().transaction(2, new byte[] {0x42}, 0, 1, data, 0, 1)).isEqualTo(Status.OK);
        assertThat((int) data[0]).isEqualTo(42);
        byte[] vendor = new byte[4];
        sensor.port.i2c().transaction(2, new byte[] {0x08}, 0, 1, vendor, 0, 4);
        assertThat(new String(vendor, StandardCharsets.US_ASCII)).isEqualTo("LEGO");
        assertThat(sensor.port.i2c().transaction(8, new byte[] {0x42}, 0, 1, data, 0, 1)).isEqualTo(Status.NO_ANSWER);
    }

    @Test
    void infraredProximityIsPercentOf70Centimetres() {
        SensorBench sensor = SensorBench.of(SensorType.EV3_INFRARED, wallAt(0.35));
        sensor.port.uart().initialise(0);
        sensor.bench.runMillis(100);
        assertThat((int) sensor.bytes(1)[0]).isBetween(50, 56);
        SensorBench free = SensorBench.of(SensorType.EV3_INFRARED);
        free.port.uart().initialise(0);
        assertThat((int) free.bytes(1)[0]).isEqualTo(100);
    }

    @Test
    void infraredSeeksBeaconsToTheRightWithPositiveHeading() {
        World world = new World("beacons", -2, -2, 4, 4, List.of(), List.of(), List.of(),
                List.of(new Beacon("right", 2, new Point2(0.56, 0.5))), List.of(), Optional.empty(), List.of(), "");
        SensorBench sensor = new SensorBench(world, SensorBench.front(SensorType.EV3_INFRARED, 0.06), true);
        sensor.port.uart().initialise(1);
        byte[] seek = sensor.bytes(8);
        assertThat(seek[0]).isZero();
        assertThat(seek[1]).isEqualTo((byte) 128);
        assertThat((int) seek[2]).isCloseTo(19, offset(1));
        assertThat((int) seek[3]).isCloseTo(35, offset(1));
    }

    @Test
    void infraredReceivesTheRemote() {
        SensorBench sensor = SensorBench.of(SensorType.EV3_INFRARED);
        sensor.port.uart().initialise(2);
        assertThat(sensor.bytes(4)).containsExactly(0, 0, 0, 0);
        sensor.bench.devices.remote(3, 5);
        assertThat(sensor.bytes(4)).containsExactly(0, 0, 5, 0);
    }
}
