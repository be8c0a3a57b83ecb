package lejos.robotics.navigation;

/** A robot whose curve can be changed while it drives, as for following a line. */
public interface LineFollowingMoveController extends ArcRotateMoveController {
    /**
     * Drives forward along a curve and returns at once.
     *
     * @param turnRate −200 to 200: the inner wheel is slower by this many percent, to the left if positive; 0 is
     *     straight ahead, 100 turns about the inner wheel, 200 on the spot
     */
    void steer(double turnRate);

    /** Drives backward along a curve and returns at once; see {@link #steer}. */
    void steerBackward(double turnRate);
}
