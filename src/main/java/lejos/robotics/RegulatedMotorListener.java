package lejos.robotics;

/** Told when a regulated motor begins and ends a motion. Called while the motor's regulator is locked: return soon. */
public interface RegulatedMotorListener {
    /**
     * The motor was told to move from rest.
     *
     * @param motor the motor
     * @param tachoCount angle in degrees
     * @param stalled whether the motor is stalled; false here
     * @param timeStamp time in milliseconds, as {@link System#currentTimeMillis()} counts
     */
    void rotationStarted(RegulatedMotor motor, int tachoCount, boolean stalled, long timeStamp);

    /**
     * The motion is complete, or the motor stalled.
     *
     * @param motor the motor
     * @param tachoCount angle in degrees
     * @param stalled whether the motion ended because the motor could not keep up
     * @param timeStamp time in milliseconds, as {@link System#currentTimeMillis()} counts
     */
    void rotationStopped(RegulatedMotor motor, int tachoCount, boolean stalled, long timeStamp);
}
