package brickless.hardware;

/**
 * A regulated motor at one instant.
 *
 * @param state phase of the controller
 * @param tachoDegrees encoder in whole degrees, hardware frame
 * @param positionDegrees position of the controller's model, hardware frame
 * @param velocityDegreesPerSecond velocity of the controller's model, forward positive
 */
public record MotorSnapshot(RegulationState state, int tachoDegrees, float positionDegrees,
        float velocityDegreesPerSecond) {}
