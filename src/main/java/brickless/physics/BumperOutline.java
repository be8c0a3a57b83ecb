package brickless.physics;

import brickless.world.Point2;
import brickless.world.RobotModel.SensorMount;
import java.util.List;

/** The outline that presses a touch sensor. */
final class BumperOutline {
    /** Half the width and the depth of the bare EV3 button, metres; used when a robot file draws none. */
    private static final double HALF_WIDTH = 0.008;
    private static final double DEPTH = 0.006;

    private BumperOutline() {}

    /** The drawn outline, or a small button in front of the sensor's position. */
    static List<Point2> of(SensorMount mount) {
        if (!mount.outline().isEmpty()) {
            return mount.outline();
        }
        double cos = StrictMath.cos(mount.headingRadians());
        double sin = StrictMath.sin(mount.headingRadians());
        return List.of(corner(mount, cos, sin, 0, -HALF_WIDTH), corner(mount, cos, sin, DEPTH, -HALF_WIDTH),
                corner(mount, cos, sin, DEPTH, HALF_WIDTH), corner(mount, cos, sin, 0, HALF_WIDTH));
    }

    private static Point2 corner(SensorMount mount, double cos, double sin, double ahead, double right) {
        return new Point2(mount.position().x() + cos * ahead - sin * right,
                mount.position().y() + sin * ahead + cos * right);
    }
}
