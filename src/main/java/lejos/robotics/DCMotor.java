package lejos.robotics;

/** A motor driven by a fraction of full power, without regulation. */
public interface DCMotor extends BaseMotor {
    /**
     * Sets the power for present and later motion.
     *
     * @param power percent of full power, 0 to 100 (−100 to −1: the opposite direction)
     */
    void setPower(int power);

    /** The power last set, in percent. */
    int getPower();
}
