package lejos.robotics;

/** What every motor can do. */
public interface BaseMotor {
    /** Starts turning forward and returns at once; turns until told otherwise. */
    void forward();

    /** Starts turning backward and returns at once; turns until told otherwise. */
    void backward();

    /** Stops and holds against turning. A regulated motor decelerates first and returns when it stands still. */
    void stop();

    /**
     * Takes power away, so that the motor turns freely. A regulated motor decelerates first and returns when it stands
     * still.
     */
    void flt();

    /** True while the motor moves, or is told to move, by a command; a hand that turns it does not count. */
    boolean isMoving();
}
