package brickless.simulation;

/** A robot drove, or was pushed, over the edge of the table. */
final class RobotFellException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    RobotFellException(String robot) {
        super("fell: a wheel of " + robot + " is over the edge of the table", null, false, false);
    }
}
