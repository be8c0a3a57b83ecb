package lejos.robotics.navigation;

/** Something that knows how the robot moves. */
public interface MoveProvider {
    /** The move in progress, as far as it has come. */
    Move getMovement();

    /** Adds a listener to starts and stops; listeners are called in the order added. */
    void addMoveListener(MoveListener listener);
}
