package brickless.device;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.TestWorlds;
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
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What other sensors, robots and walls do to ultrasonic and infrared sensors. */
class InterferenceTest {
    private static final byte NO_BEACON = (byte) 128;

    /** Echoes of the first robot's sensor with its neighbour, which looks back at it, pinging or dark. */
    private static List<Integer> echoes(boolean neighbourPings) {
        Arena arena = new Arena(TestWorlds.with(TestWorlds.wall("wall", 0.9, -2, 1, 2)), List.of(
                new Entrant("a", TestWorlds.educator(SensorBench.front(SensorType.EV3_ULTRASONIC, 0.06)),
                        new Pose2(0, 0, 0)),
                new Entrant("b", TestWorlds.educator(SensorBench.front(SensorType.EV3_ULTRASONIC, 0.06)),
                        new Pose2(0.7, 0.3, Math.PI))), ArenaSettings.of(false));
        RobotDevices[] devices = new RobotDevices[2];
        FakeProcessor processor = new FakeProcessor(arena.stepNanos(), now -> {
            arena.step();
            for (RobotDevices robot : devices) {
                robot.afterStep(now + arena.stepNanos());
            }
        });
        for (int i = 0; i < 2; i++) {
            devices[i] = RobotDevices.of(arena, arena.robots().get(i), processor, 1, false);
        }
        devices[0].sensor(0).uart().initialise(0);
        devices[1].sensor(0).uart().initialise(neighbourPings ? 0 : 2);
        List<Integer> values = new ArrayList<>();
        byte[] bytes = new byte[2];
        for (int i = 0; i < 100; i++) {
            processor.runMillis(10);
            devices[0].sensor(0).uart().read(bytes, 0, 2);
            values.add(bytes[0] & 0xff | bytes[1] << 8);
        }
        return values;
    }

    @Test
    void pingsOfAnotherRobotChangeNoEcho() {
        assertThat(echoes(true)).isEqualTo(echoes(false)).allSatisfy(mm -> assertThat(mm).isBetween(820, 860));
    }

    private static byte[] seek(double x, double y, Obstacle... obstacles) {
        World world = new World("beacons", -4, -4, 8, 8, List.of(), List.of(obstacles), List.of(),
                List.of(new Beacon("beacon", 3, new Point2(0.06 + x, y))), List.of(), Optional.empty(), List.of(), "");
        SensorBench sensor = new SensorBench(world, SensorBench.front(SensorType.EV3_INFRARED, 0.06), true);
        sensor.port.uart().initialise(1);
        return sensor.bytes(8);
    }

    /** 60 degrees to the side read 25, 2 m read 100; the right is positive. */
    @ParameterizedTest(name = "beacon at {0} degrees, {1} m")
    @CsvSource({"0,0.5,0,25", "36,1,15,50", "-48,1,-20,50", "60,1.5,25,75", "-60,1.98,-25,99", "90,1,25,50",
        "12,0.2,5,10"})
    void beaconIsSeenByBearingAndDistance(double degrees, double metres, int heading, int distance) {
        byte[] seen = seek(metres * Math.cos(Math.toRadians(degrees)), metres * Math.sin(Math.toRadians(degrees)));
        assertThat(seen).containsExactly(0, NO_BEACON, 0, NO_BEACON, heading, distance, 0, NO_BEACON);
    }

    @Test
    void beaconBehindAWallOrTheRobotOrTooFarAwayIsNotSeen() {
        assertThat(seek(1, 0, TestWorlds.wall("wall", 0.4, -0.2, 0.5, 0.2))[5]).isEqualTo(NO_BEACON);
        assertThat(seek(-1, 0)[5]).isEqualTo(NO_BEACON);
        assertThat(seek(2.1, 0)[5]).isEqualTo(NO_BEACON);
        assertThat(seek(1, 0, TestWorlds.wall("beside", 0.4, 0.1, 0.5, 0.2))[5]).isEqualTo((byte) 50);
    }

    @Test
    void remoteTellsAllCodesOnAllChannels() {
        SensorBench sensor = SensorBench.of(SensorType.EV3_INFRARED);
        sensor.port.uart().initialise(2);
        for (int channel = 1; channel <= 4; channel++) {
            for (int code = 0; code <= 11; code++) {
                sensor.bench.devices.remote(channel, code);
                byte[] expected = new byte[4];
                expected[channel - 1] = (byte) code;
                assertThat(sensor.bytes(4)).isEqualTo(expected);
            }
            sensor.bench.devices.remote(channel, 0);
        }
    }

    /** Proximity is 100 at 70 cm for white things; black ones seem a quarter further away. */
    @ParameterizedTest
    @CsvSource({"0.07,10", "0.35,50", "0.56,80", "0.69,99", "0.8,100"})
    void proximityIsProportionalToTheDistanceOfWhiteThings(double metres, int percent) {
        Obstacle white = new Obstacle("white", List.of(TestWorlds.box(0.06 + metres, -1, 2, 1)), false, 0, 0.1, 0.5,
                false, new Rgb(255, 255, 255));
        SensorBench sensor = SensorBench.of(SensorType.EV3_INFRARED, white);
        sensor.port.uart().initialise(0);
        assertThat((int) sensor.bytes(1)[0]).isEqualTo(percent);
    }
}
