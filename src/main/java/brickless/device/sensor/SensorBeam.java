package brickless.device.sensor;

import brickless.physics.Aim;
import brickless.world.Point2;
import java.util.ArrayList;
import java.util.List;

/**
 * What a distance sensor reached with its last measurement, seen from where it is now: for pictures.
 *
 * @param from the sensor's eye
 * @param ends where its rays ended
 * @param metres distance it tells; not finite: nothing was met
 */
public record SensorBeam(Point2 from, List<Point2> ends, double metres) {
    public SensorBeam {
        ends = List.copyOf(ends);
    }

    /** A beam of rays with these directions against the sensor's own, radians clockwise, and lengths. */
    static SensorBeam of(Aim aim, double[] turns, double[] lengths, double metres) {
        List<Point2> ends = new ArrayList<>();
        for (int i = 0; i < turns.length; i++) {
            double heading = aim.headingRadians + turns[i];
            ends.add(new Point2(aim.x + lengths[i] * StrictMath.cos(heading),
                    aim.y + lengths[i] * StrictMath.sin(heading)));
        }
        return new SensorBeam(new Point2(aim.x, aim.y), ends, metres);
    }
}
