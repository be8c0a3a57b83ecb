package brickless.world.svg;

import brickless.world.SensorType;

/** What a robot file may leave out. */
final class RobotDefaults {
    /** Mass of a robot: assumption, EV3 brick with batteries (about 0.28 kg), two large motors, sensors and bricks. */
    static final double MASS_KILOGRAMS = 0.75;
    /** Tyre of the EV3 core set. */
    static final double TYRE_MILLIMETRES = 56;
    /** Friction coefficient of a free support: assumption, steel ball in a plastic cup, rolling. */
    static final double CASTER_FRICTION = 0.05;
    /** Angle of a closed claw: assumption, a quarter turn of the motor. */
    static final double CLAW_CLOSED_DEGREES = 90;
    /** Farthest point of a robot from its origin. */
    static final double GREATEST_REACH_METRES = 1;

    private RobotDefaults() {}

    /**
     * Height of the eye or button above the floor: assumptions for an EV3 standing on 56 mm tyres; colour at its best
     * distance (ev3dev).
     */
    static double sensorHeightMillimetres(SensorType type) {
        return switch (type) {
            case EV3_COLOR, NXT_COLOR, NXT_LIGHT -> 8;
            case EV3_TOUCH, NXT_TOUCH -> 30;
            default -> 60;
        };
    }

    /** Whether the sensor looks at the floor below its middle instead of ahead from its front edge. */
    static boolean looksDown(SensorType type) {
        return switch (type) {
            case EV3_COLOR, NXT_COLOR, NXT_LIGHT -> true;
            default -> false;
        };
    }
}
