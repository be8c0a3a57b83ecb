package lejos.robotics.geometry;

/** A line between two points in single precision, as walls on maps are. Equal only to itself. */
public class Line extends Line2D.Float {
    /** Share of a coordinate that rounding may move a crossing beyond the end of a line. */
    private static final float TOLERANCE = 1e-5f;

    /** A line. */
    public Line(float x1, float y1, float x2, float y2) {
        super(x1, y1, x2, y2);
    }

    /**
     * Where this line and another cross, ends included.
     *
     * @return the point; null if there is none, or if the lines are parallel
     */
    public Point intersectsAt(Line l) {
        double dx = (double) x2 - x1;
        double dy = (double) y2 - y1;
        double otherDx = (double) l.x2 - l.x1;
        double otherDy = (double) l.y2 - l.y1;
        double cross = dx * otherDy - dy * otherDx;
        if (cross == 0) {
            return null;
        }
        double part = (((double) l.x1 - x1) * otherDy - ((double) l.y1 - y1) * otherDx) / cross;
        Point crossing = new Point((float) (x1 + part * dx), (float) (y1 + part * dy));
        return reaches(crossing) && l.reaches(crossing) ? crossing : null;
    }

    /** Smallest distance between points of this line and another. */
    public double segDist(Line l) {
        if (intersectsLine(l)) {
            return 0;
        }
        double toOther = Math.min(l.ptSegDist(x1, y1), l.ptSegDist(x2, y2));
        double fromOther = Math.min(ptSegDist(l.x1, l.y1), ptSegDist(l.x2, l.y2));
        return Math.min(toOther, fromOther);
    }

    /** Makes this line longer at each end; shorter if negative. A line without length grows along x. */
    public void lengthen(float delta) {
        double angle = StrictMath.atan2(y2 - y1, x2 - x1);
        float dx = delta * (float) StrictMath.cos(angle);
        float dy = delta * (float) StrictMath.sin(angle);
        setLine(x1 - dx, y1 - dy, x2 + dx, y2 + dy);
    }

    /** Length of the line. */
    public float length() {
        return (float) Point2D.distance(x1, y1, x2, y2);
    }

    @Override
    public Point getP1() {
        return new Point(x1, y1);
    }

    @Override
    public Point getP2() {
        return new Point(x2, y2);
    }

    /** Whether a point known to be on the straight line is between its ends, as far as can be told. */
    private boolean reaches(Point p) {
        return within(p.x, x1, x2) && within(p.y, y1, y2);
    }

    private static boolean within(float value, float end, float otherEnd) {
        float margin = TOLERANCE * Math.max(1, Math.max(Math.abs(end), Math.abs(otherEnd)));
        return value >= Math.min(end, otherEnd) - margin && value <= Math.max(end, otherEnd) + margin;
    }
}
