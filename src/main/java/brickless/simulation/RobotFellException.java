package brickless.simulation;

/** A robot drove over the edge of the table. */
final class RobotFellException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    RobotFellException(String robot) {
        super("fell: robot " + robot + " drove a wheel over the edge of the table", null, false, false);
    }
}
