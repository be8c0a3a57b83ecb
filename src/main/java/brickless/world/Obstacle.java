package brickless.world;

import java.util.List;

/**
 * Something solid on the floor.
 *
 * @param id element id, or a generated one
 * @param outlines simple closed polygons that together form the body, possibly concave, at their drawn place
 * @param movable whether it can be pushed
 * @param massKilograms mass of a movable one
 * @param heightMetres height above the floor
 * @param friction coefficient of friction against the floor and other bodies
 * @param soundAbsorbing whether it swallows ultrasound
 * @param colour drawn fill
 */
public record Obstacle(String id, List<List<Point2>> outlines, boolean movable, double massKilograms,
        double heightMetres, double friction, boolean soundAbsorbing, Rgb colour) {
    public Obstacle {
        outlines = outlines.stream().map(List::copyOf).toList();
    }
}
