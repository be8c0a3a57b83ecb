package brickless.world.svg;

/** Counts what a drawing costs, so that a small hostile file cannot grow without end. Used by one thread. */
final class PointBudget {
    private int points = Limits.POINTS;
    private int visits = Limits.VISITS;

    void spend(int count) throws MalformedValueException {
        points -= count;
        if (points < 0) {
            throw new MalformedValueException("the drawing has more than " + Limits.POINTS
                    + " points after curves are flattened");
        }
    }

    void visit() throws MalformedValueException {
        if (--visits < 0) {
            throw new MalformedValueException("the drawing has more than " + Limits.VISITS
                    + " elements after use is expanded");
        }
    }
}
