package lejos.robotics.navigation;

/**
 * A robot that can drive along arcs of a circle. A positive radius means that the centre is to the left.
 *
 * <p>Implementations differ in what the sign of an arc's angle means together with a negative radius; each says so.
 */
public interface ArcMoveController extends MoveController {
    /** Least radius of an arc; 0 if the robot can turn on the spot. */
    double getMinRadius();

    /** Sets the least radius of an arc. */
    void setMinRadius(double radius);

    /** Starts driving forward along an arc and returns at once. */
    void arcForward(double radius);

    /** Starts driving backward along an arc and returns at once. */
    void arcBackward(double radius);

    /** Drives along an arc of an angle in degrees and returns when done. */
    void arc(double radius, double angle);

    /** Drives along an arc of an angle in degrees; returns at once if so told, else when done. */
    void arc(double radius, double angle, boolean immediateReturn);

    /** Drives a distance along an arc and returns when done. */
    void travelArc(double radius, double distance);

    /** Drives a distance along an arc; returns at once if so told, else when done. */
    void travelArc(double radius, double distance, boolean immediateReturn);
}
