package lejos.robotics.mapping;

import lejos.robotics.geometry.Point;
import lejos.robotics.geometry.Rectangle;
import lejos.robotics.navigation.Pose;

/** A map that knows what a range finder would measure. */
public interface RangeMap {
    /** Distance from a pose, along its heading, to the nearest wall; −1 if there is none in sight. */
    float range(Pose p);

    /** Whether a point is in the mapped area. */
    boolean inside(Point p);

    /** A rectangle around the mapped area. */
    Rectangle getBoundingRect();
}
