package brickless.trace;

import brickless.world.Point2;
import brickless.world.RobotModel.Claw;
import java.util.ArrayList;
import java.util.List;

/**
 * How a jaw of a claw is shown: what is drawn wholly on one side of the claw's middle swings inwards about its end
 * nearest the pivot, half way to the middle when the claw is closed. A picture only: bodies hit the jaws where they are
 * drawn.
 *
 * @param side −1 for what is left of the pivot, 1 for what is right of it
 * @param hinge in the robot's frame, metres
 * @param closedRadians clockwise angle of the closed jaw
 */
record Jaw(int side, Point2 hinge, double closedRadians) {
    private static final double CLOSED_PART = 0.5;

    /** The jaws of a claw, left one first; none for an arm that spans the middle. */
    static List<Jaw> of(Claw claw) {
        List<Jaw> jaws = new ArrayList<>();
        for (int side = -1; side <= 1; side += 2) {
            int wanted = side;
            List<Point2> points = claw.outlines().stream().filter(ring -> side(claw, ring) == wanted)
                    .flatMap(List::stream).toList();
            if (!points.isEmpty()) {
                jaws.add(jaw(side, claw.pivot(), points));
            }
        }
        return jaws;
    }

    /** On which side an outline lies: −1 left, 1 right, 0 across the middle. */
    static int side(Claw claw, List<Point2> ring) {
        double middle = claw.pivot().y();
        if (ring.stream().allMatch(p -> p.y() <= middle)) {
            return -1;
        }
        return ring.stream().allMatch(p -> p.y() >= middle) ? 1 : 0;
    }

    private static Jaw jaw(int side, Point2 pivot, List<Point2> points) {
        double rear = points.stream().mapToDouble(Point2::x).min().orElseThrow();
        double front = points.stream().mapToDouble(Point2::x).max().orElseThrow();
        double middle = points.stream().mapToDouble(Point2::y).average().orElseThrow();
        boolean forward = Math.abs(rear - pivot.x()) <= Math.abs(front - pivot.x());
        double swing = StrictMath.atan2(Math.abs(middle - pivot.y()), front - rear) * CLOSED_PART;
        return new Jaw(side, new Point2(forward ? rear : front, middle), (forward ? -side : side) * swing);
    }

    /** How far a claw is closed, 0 to 1, at a count of its motor in degrees. */
    static double closed(Claw claw, double tachoDegrees) {
        double turned = (claw.inverted() ? -tachoDegrees : tachoDegrees) - claw.minDegrees();
        return Math.max(0, Math.min(1, turned / (claw.maxDegrees() - claw.minDegrees())));
    }
}
