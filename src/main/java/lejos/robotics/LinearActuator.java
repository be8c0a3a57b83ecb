package lejos.robotics;

/** A motor that pushes a rod out and pulls it in. Positions are in encoder ticks. */
public interface LinearActuator extends Encoder {
    /** Sets the power of present and later strokes, in percent, 0 to 100. */
    void setPower(int power);

    /** The power last set, in percent. */
    int getPower();

    /**
     * Moves by a distance.
     *
     * @param distance ticks, positive outward
     * @param immediateReturn true to return at once, false to return when done or stalled
     */
    void move(int distance, boolean immediateReturn);

    /**
     * Moves to a position.
     *
     * @param position ticks from the zero position
     * @param immediateReturn true to return at once, false to return when done or stalled
     */
    void moveTo(int position, boolean immediateReturn);

    /** Whether a stroke is in progress. */
    boolean isMoving();

    /** Whether the last stroke ended because the rod could not move. */
    boolean isStalled();

    /** Stops at once. */
    void stop();

    /** Position in ticks, positive outward. */
    @Override
    int getTachoCount();

    /** Makes the present position zero. */
    @Override
    void resetTachoCount();
}
