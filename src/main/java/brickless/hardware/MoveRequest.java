package brickless.hardware;

/**
 * One regulated move.
 *
 * @param speedDegreesPerSecond requested speed, 0 or more; 0 means: stop with the given deceleration
 * @param accelerationDegreesPerSecondSquared acceleration of all ramps; less than 1 counts as 1
 * @param limitDegrees absolute target angle in the hardware frame, or ±{@link MotorRegulation#NO_LIMIT}
 * @param hold whether the position is held actively at the end; otherwise the motor coasts
 */
public record MoveRequest(float speedDegreesPerSecond, int accelerationDegreesPerSecondSquared, int limitDegrees,
        boolean hold) {}
