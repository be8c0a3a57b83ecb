package brickless.device;

import brickless.hardware.MotorRegulation;
import brickless.hardware.MoveRequest;
import brickless.physics.Arena;
import brickless.physics.ArenaSettings;
import brickless.physics.Entrant;
import brickless.physics.RobotBody;
import brickless.world.Pose2;
import brickless.world.RobotModel;
import brickless.world.World;
import java.util.List;

/** One robot with all its devices in an arena; time passes when the test lets it. */
public final class RobotBench {
    public static final int LEFT = 1;
    public static final int RIGHT = 2;

    public final Arena arena;
    public final RobotBody robot;
    public final RobotDevices devices;
    public final FakeProcessor processor;

    public RobotBench(World world, RobotModel model, Pose2 start, ArenaSettings settings) {
        this(world, model, start, settings, 1);
    }

    public RobotBench(World world, RobotModel model, Pose2 start, ArenaSettings settings, long seed) {
        arena = new Arena(world, List.of(new Entrant("robot", model, start)), settings);
        robot = arena.robots().get(0);
        RobotDevices[] own = new RobotDevices[1];
        processor = new FakeProcessor(settings.stepNanos(), now -> {
            long end = now + settings.stepNanos();
            own[0].beforeStep(end);
            arena.step();
            own[0].afterStep(end);
        });
        devices = RobotDevices.of(arena, robot, processor, seed, settings.ideal());
        own[0] = devices;
    }

    public static RobotBench ideal(World world, RobotModel model) {
        return new RobotBench(world, model, new Pose2(0, 0, 0), ArenaSettings.of(true));
    }

    public static RobotBench real(World world, RobotModel model) {
        return new RobotBench(world, model, new Pose2(0, 0, 0), ArenaSettings.of(false));
    }

    /** Both wheels at a fixed duty. */
    public void drive(int left, int right) {
        devices.motor(LEFT).drive(left);
        devices.motor(RIGHT).drive(right);
    }

    /** Turns both wheels by whole degrees at a speed, waiting for the end. */
    public void rotate(int left, int right, float speed) {
        start(LEFT, left, speed);
        start(RIGHT, right, speed);
        devices.motor(LEFT).awaitStandstill();
        devices.motor(RIGHT).awaitStandstill();
    }

    private void start(int port, int degrees, float speed) {
        MotorRegulation motor = devices.motor(port).regulation();
        int from = Math.round(motor.snapshot().positionDegrees());
        motor.move(new MoveRequest(speed, 6000, from + degrees, true));
    }

    public void runMillis(long millis) {
        processor.runMillis(millis);
    }

    public double headingDegrees() {
        return Math.toDegrees(robot.headingRadians());
    }
}
