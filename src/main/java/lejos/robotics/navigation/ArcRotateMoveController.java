package lejos.robotics.navigation;

/** A robot that can drive along arcs and turn on the spot. */
public interface ArcRotateMoveController extends ArcMoveController, RotateMoveController {
}
