package brickless.hardware;

/**
 * Closed-loop control of one motor: trapezoid planner, tracking loop, stall detection and hold, run in the simulator's
 * control tick.
 *
 * <p>Angles are degrees in the hardware frame (the frame of {@link MotorSocket#tachoDegrees()} without any user
 * offset), forward positive. {@link MotorSocket#resetTacho()} also moves this frame.
 */
public interface MotorRegulation {
    /** Limit of a move without end; used with a sign. */
    int NO_LIMIT = 0x7fffffff;

    /** Sets the controller's constants; they take effect with the next control tick. */
    void configure(RegulationTuning tuning);

    /**
     * Starts a move at once, replacing the running one and starting from the model's present position and velocity.
     * Returns immediately; {@link #snapshot()} reports a moving state when it returns (unless the plan is empty).
     */
    void move(MoveRequest request);

    /**
     * Re-plans the running move to the same target with another speed; ignored unless it is starting, accelerating or
     * cruising.
     */
    void adjustSpeed(float degreesPerSecond);

    /**
     * Re-plans the running move to the same target with another acceleration; ignored unless it is starting,
     * accelerating or cruising.
     */
    void adjustAcceleration(int degreesPerSecondSquared);

    /**
     * Sets when a move is given up as stalled; takes effect with the next planned move.
     *
     * @param errorDegrees lag of the encoder behind the model that counts as blocked, in degrees (default 50)
     * @param timeMillis how long the lag must last, in milliseconds (default 1000)
     */
    void setStallThreshold(int errorDegrees, int timeMillis);

    /** State, encoder, model position and model velocity of one instant. */
    MotorSnapshot snapshot();

    /** Blocks the calling program thread until the motor is not moving. Interrupts are ignored and kept. */
    void awaitStandstill();
}
