package brickless.world;

import java.util.List;
import java.util.Optional;

/**
 * A robot as drawn: origin in the middle of the driven axle, +x forward, +y to the robot's right, metres.
 *
 * @param name file name without extension
 * @param chassis outlines that collide, simple polygons, possibly concave
 * @param massKilograms mass of the whole robot
 * @param wheels driven wheels
 * @param casters free supports
 * @param sensors sensors, those on turrets included
 * @param turrets groups turned by a motor
 * @param claws limited-angle mechanisms
 * @param svg the drawing's text with its images embedded, for pictures of a run
 */
public record RobotModel(String name, List<List<Point2>> chassis, double massKilograms, List<Wheel> wheels,
        List<Caster> casters, List<SensorMount> sensors, List<Turret> turrets, List<Claw> claws, String svg) {
    public RobotModel {
        chassis = chassis.stream().map(List::copyOf).toList();
        wheels = List.copyOf(wheels);
        casters = List.copyOf(casters);
        sensors = List.copyOf(sensors);
        turrets = List.copyOf(turrets);
        claws = List.copyOf(claws);
    }

    /**
     * A driven wheel.
     *
     * @param id element id
     * @param port 0 to 3 for A to D
     * @param motor motor kind
     * @param diameterMetres tyre diameter
     * @param gearRatio motor turns per wheel turn
     * @param inverted whether forward of the motor turns the wheel backward
     * @param position contact point
     * @param headingRadians rolling direction, 0 = robot's forward
     * @param omni whether rollers let it slide sideways freely
     * @param backlashRadians how far the wheel can be turned while its motor stands still
     */
    public record Wheel(String id, int port, MotorType motor, double diameterMetres, double gearRatio, boolean inverted,
            Point2 position, double headingRadians, boolean omni, double backlashRadians) {
        /** A wheel without backlash. */
        public Wheel(String id, int port, MotorType motor, double diameterMetres, double gearRatio, boolean inverted,
                Point2 position, double headingRadians, boolean omni) {
            this(id, port, motor, diameterMetres, gearRatio, inverted, position, headingRadians, omni, 0);
        }
    }

    /** A free support at a contact point; {@code dragCoefficient} is its friction coefficient. */
    public record Caster(String id, Point2 position, double dragCoefficient) {}

    /**
     * A sensor.
     *
     * @param id element id
     * @param port 0 to 3 for S1 to S4
     * @param type sensor kind
     * @param position of its eye or button, in the frame of the robot with turrets at angle 0
     * @param headingRadians direction it looks or is pressed from, 0 = forward
     * @param heightMetres height of its eye above the floor
     * @param outline drawn body; for touch sensors the bumper that must be hit
     * @param turret id of the turret that carries it
     */
    public record SensorMount(String id, int port, SensorType type, Point2 position, double headingRadians,
            double heightMetres, List<Point2> outline, Optional<String> turret) {
        public SensorMount {
            outline = List.copyOf(outline);
        }
    }

    /**
     * A group turned by a motor about a pivot; {@code outlines} collide and turn with it. {@code backlashRadians} is
     * how far it can be turned while its motor stands still.
     */
    public record Turret(String id, int port, MotorType motor, double gearRatio, boolean inverted, Point2 pivot,
            List<List<Point2>> outlines, double backlashRadians) {
        /** A turret without backlash. */
        public Turret(String id, int port, MotorType motor, double gearRatio, boolean inverted, Point2 pivot,
                List<List<Point2>> outlines) {
            this(id, port, motor, gearRatio, inverted, pivot, outlines, 0);
        }
    }

    /**
     * A claw or arm moved between two motor angles; open at {@code minDegrees}, closed at {@code maxDegrees};
     * {@code outlines} collide.
     */
    public record Claw(String id, int port, MotorType motor, double minDegrees, double maxDegrees, boolean inverted,
            Point2 pivot, List<List<Point2>> outlines) {}
}
