package lejos.robotics;

/** A model-maker's servo, set by the length of pulses. */
public interface Servo {
    /** Turns to an angle in degrees within the range of travel. */
    void setAngle(float angle);

    /** The angle last set, in degrees. */
    float getAngle();

    /** Sets the length of pulses in microseconds. */
    void setpulseWidth(int microSeconds);

    /** The length of pulses in microseconds. */
    int getpulseWidth();

    /**
     * Describes the servo.
     *
     * @param microsecLOW pulse at one end of the travel, in microseconds
     * @param microsecHIGH pulse at the other end
     * @param travelRange travel between them in degrees
     */
    void setRange(int microsecLOW, int microsecHIGH, int travelRange);
}
