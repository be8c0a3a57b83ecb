package brickless;

import brickless.world.MotorType;
import brickless.world.Obstacle;
import brickless.world.Paint;
import brickless.world.Point2;
import brickless.world.Rgb;
import brickless.world.RobotModel;
import brickless.world.RobotModel.Caster;
import brickless.world.RobotModel.SensorMount;
import brickless.world.RobotModel.Wheel;
import brickless.world.World;
import java.util.List;
import java.util.Optional;

/** Worlds and robots for tests of physics and devices. */
public final class TestWorlds {
    private TestWorlds() {}

    /** Four by four metres around the origin with some obstacles and paint. */
    public static World world(List<Obstacle> obstacles, List<Paint> floor) {
        return new World("test", -2, -2, 4, 4, floor, obstacles, List.of(), List.of(), List.of(), Optional.empty(),
                List.of(), "");
    }

    public static World with(Obstacle... obstacles) {
        return world(List.of(obstacles), List.of());
    }

    /** An upright rectangle, metres. */
    public static List<Point2> box(double left, double top, double right, double bottom) {
        return List.of(new Point2(left, top), new Point2(right, top), new Point2(right, bottom),
                new Point2(left, bottom));
    }

    public static Obstacle wall(String id, double left, double top, double right, double bottom) {
        return new Obstacle(id, List.of(box(left, top, right, bottom)), false, 0, 0.1, 0.5, false,
                new Rgb(200, 200, 200));
    }

    public static Obstacle crate(String id, double x, double y, double size, double kilograms) {
        return new Obstacle(id, List.of(box(x - size / 2, y - size / 2, x + size / 2, y + size / 2)), true, kilograms,
                0.1, 0.5, false,
                new Rgb(200, 150, 100));
    }

    /** The EV3 educator: wheels of 56 mm on B and C, track 114 mm, ball caster behind, 0.8 kg. */
    public static RobotModel educator(SensorMount... sensors) {
        return robot(List.of(wheel("left", 1, -0.057, 0.056), wheel("right", 2, 0.057, 0.056)), List.of(sensors));
    }

    public static Wheel wheel(String id, int port, double y, double diameter) {
        return new Wheel(id, port, MotorType.LARGE, diameter, 1, false, new Point2(0, y), 0, false);
    }

    public static RobotModel robot(List<Wheel> wheels, List<SensorMount> sensors) {
        return new RobotModel("educator", List.of(box(-0.11, -0.07, 0.05, 0.07)), 0.8, wheels,
                List.of(new Caster("ball", new Point2(-0.09, 0), 0.1)), sensors, List.of(), List.of(), "");
    }
}
