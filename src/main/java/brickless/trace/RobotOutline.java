package brickless.trace;

import brickless.trace.RobotSample.MotorSample;
import brickless.units.Angles;
import brickless.world.Point2;
import brickless.world.RobotModel;
import brickless.world.RobotModel.Claw;
import brickless.world.RobotModel.Turret;
import java.util.ArrayList;
import java.util.List;

/** The outlines of a robot with its turrets and jaws where its motors have turned them. No state. */
final class RobotOutline {
    private RobotOutline() {}

    /** Outlines in the robot's frame, metres. */
    static List<List<Point2>> of(RobotModel model, List<MotorSample> motors) {
        List<List<Point2>> outlines = new ArrayList<>(model.chassis());
        for (Turret turret : model.turrets()) {
            double angle = Angles.radiansFromDegrees(tacho(motors, turret.port()) * turnsPerMotorTurn(turret));
            turret.outlines().forEach(ring -> outlines.add(turned(ring, turret.pivot(), angle)));
        }
        for (Claw claw : model.claws()) {
            double closed = Jaw.closed(claw, tacho(motors, claw.port()));
            List<Jaw> jaws = Jaw.of(claw);
            claw.outlines().forEach(ring -> outlines.add(swung(claw, ring, jaws, closed)));
        }
        return outlines;
    }

    /** Clockwise turns of a turret per turn of its motor: motors turn turrets to the left unless inverted. */
    static double turnsPerMotorTurn(Turret turret) {
        return (turret.inverted() ? 1 : -1) / turret.gearRatio();
    }

    private static double tacho(List<MotorSample> motors, int port) {
        return motors.stream().filter(motor -> motor.port() == 'A' + port).mapToDouble(MotorSample::tachoDegrees)
                .findFirst().orElse(0);
    }

    private static List<Point2> swung(Claw claw, List<Point2> ring, List<Jaw> jaws, double closed) {
        int side = Jaw.side(claw, ring);
        return jaws.stream().filter(jaw -> jaw.side() == side).findFirst()
                .map(jaw -> turned(ring, jaw.hinge(), closed * jaw.closedRadians())).orElse(ring);
    }

    private static List<Point2> turned(List<Point2> ring, Point2 pivot, double radians) {
        double cos = StrictMath.cos(radians);
        double sin = StrictMath.sin(radians);
        return ring.stream().map(p -> new Point2(pivot.x() + cos * (p.x() - pivot.x()) - sin * (p.y() - pivot.y()),
                pivot.y() + sin * (p.x() - pivot.x()) + cos * (p.y() - pivot.y()))).toList();
    }
}
