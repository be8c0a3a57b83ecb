package brickless.simulation;

import brickless.trace.BodySample;
import brickless.world.Point2;
import brickless.world.Pose2;
import brickless.world.Rgb;
import java.util.List;
import java.util.Optional;

/**
 * The whole arena at one instant, for a picture: what moves, and what the sensors see. Metres and radians clockwise, in
 * the drawing's frame.
 *
 * @param timeNanos simulated time
 * @param robots every robot, in the order of the world
 * @param bodies movable obstacles that are not where they were drawn
 */
public record Frame(long timeNanos, List<RobotFrame> robots, List<BodySample> bodies) {
    public Frame {
        robots = List.copyOf(robots);
        bodies = List.copyOf(bodies);
    }

    /** One robot: where its origin is, what turns on it, and what its sensors see. */
    public record RobotFrame(String name, Pose2 pose, List<Part> parts, List<Beam> beams, List<Spot> spots) {
        public RobotFrame {
            parts = List.copyOf(parts);
            beams = List.copyOf(beams);
            spots = List.copyOf(spots);
        }
    }

    /**
     * Element id, letter of the motor's port, and the clockwise angle of a turret against the robot or the angle of a
     * claw's motor.
     */
    public record Part(String id, char port, double angleRadians) {}

    /**
     * What a distance sensor reached with its last measurement.
     *
     * @param port number 1 to 4
     * @param kind name in the vocabulary of robot files
     * @param from the sensor's eye
     * @param ends where its rays ended
     * @param metres distance it tells; not finite: nothing was met
     */
    public record Beam(int port, String kind, Point2 from, List<Point2> ends, double metres) {}

    /**
     * What a colour or light sensor looks at.
     *
     * @param port number 1 to 4
     * @param kind name in the vocabulary of robot files
     * @param at middle of the spot
     * @param radiusMetres its radius
     * @param colour its mean colour; empty while the sensor is off, or where there is no floor
     */
    public record Spot(int port, String kind, Point2 at, double radiusMetres, Optional<Rgb> colour) {}
}
