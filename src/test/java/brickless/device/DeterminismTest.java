package brickless.device;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.TestWorlds;
import brickless.physics.ArenaSettings;
import brickless.world.Obstacle;
import brickless.world.Point2;
import brickless.world.Pose2;
import brickless.world.RobotModel;
import brickless.world.RobotModel.SensorMount;
import brickless.world.SensorType;
import brickless.world.World;
import java.nio.ByteBuffer;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** The same run gives the same state, bit for bit, on every machine and JDK. */
class DeterminismTest {
    /**
     * Hash of 60 s among walls and crates, the same on JDK 17 and 25. A change of any model changes it: then, and only
     * then, renew it.
     */
    private static final String GOLDEN = "7577a0b49e61970c0332770954eaf0d4d1c4c4d392ef798c521030eb2de5b3df";

    @Test
    void sixtySecondsAmongCratesHaveTheGoldenHash() throws NoSuchAlgorithmException {
        assertThat(hashOfRun(1)).isEqualTo(GOLDEN);
    }

    @Test
    void anotherStartGivesAnotherHash() throws NoSuchAlgorithmException {
        assertThat(hashOfRun(2)).isNotEqualTo(GOLDEN);
    }

    private static String hashOfRun(int variant) throws NoSuchAlgorithmException {
        RobotBench bench = new RobotBench(room(), robot(), new Pose2(0.01 * variant, 0, 0.1), ArenaSettings.of(false));
        for (int port = 0; port < 3; port++) {
            bench.devices.sensor(port).uart().initialise(port == 0 ? 0 : 3);
        }
        MessageDigest digest = MessageDigest.getInstance("SHA-256");
        for (int i = 0; i < 600; i++) {
            int turn = i / 20 % 5;
            bench.drive(turn == 4 ? -60 : 70, turn == 4 ? -20 : 70 - 9 * turn);
            bench.runMillis(100);
            digest(bench, digest);
        }
        return HexFormat.of().formatHex(digest.digest());
    }

    private static void digest(RobotBench bench, MessageDigest digest) {
        ByteBuffer state = ByteBuffer.allocate(1024);
        put(state, bench.robot.pose());
        bench.arena.obstacles().forEach(obstacle -> put(state, obstacle.displacement()));
        for (int port = 0; port < 4; port++) {
            state.putInt(bench.devices.motor(port).encoder()).putDouble(bench.devices.motor(port).amperes());
            for (double value : bench.devices.sensor(port).reading(bench.processor.nowNanos())) {
                state.putDouble(value);
            }
        }
        digest.update(state.array(), 0, state.position());
    }

    private static void put(ByteBuffer state, Pose2 pose) {
        state.putDouble(pose.x()).putDouble(pose.y()).putDouble(pose.headingRadians());
    }

    private static RobotModel robot() {
        return TestWorlds.educator(mount(0, SensorType.EV3_ULTRASONIC, 0.06), mount(1, SensorType.EV3_GYRO, 0.05),
                mount(2, SensorType.EV3_COLOR, 0.008),
                new SensorMount("bumper", 3, SensorType.EV3_TOUCH, new Point2(0.06, 0), 0, 0.03,
                        TestWorlds.box(0.05, -0.05, 0.06, 0.05),
                        Optional.empty()));
    }

    private static SensorMount mount(int port, SensorType type, double height) {
        return new SensorMount("s" + port, port, type, new Point2(0.045, 0), 0, height, List.of(), Optional.empty());
    }

    private static World room() {
        List<Obstacle> obstacles = new ArrayList<>(List.of(TestWorlds.wall("n", -1, -1, 1, -0.95),
                TestWorlds.wall("s", -1, 0.95, 1, 1),
                TestWorlds.wall("w", -1, -1, -0.95, 1), TestWorlds.wall("e", 0.95, -1, 1, 1)));
        for (int i = 0; i < 8; i++) {
            obstacles.add(TestWorlds.crate("c" + i, 0.4 + 0.13 * (i % 4), -0.3 + 0.3 * (i / 4), 0.1, 0.05 + 0.1 * i));
        }
        return TestWorlds.world(obstacles,
                List.of(SensorBench.everywhere(0xffffff), SensorBench.paint(0x101010, -0.5, -0.5, 0.5, 0)));
    }
}
