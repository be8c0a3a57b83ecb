package lejos.robotics.navigation;

/** Told when a robot begins and ends a move. */
public interface MoveListener {
    /** A move begins; the move says what is intended. */
    void moveStarted(Move event, MoveProvider mp);

    /** A move has ended; the move says what was done. */
    void moveStopped(Move event, MoveProvider mp);
}
