package lejos.robotics.geometry;

/**
 * An area or a line. Points on the left and on the lower-coordinate edges of an area belong to it, on the others not.
 */
public interface Shape {
    /** The smallest rectangle of whole coordinates that encloses the shape. */
    RectangleInt32 getBounds();

    /** A rectangle that encloses the shape. */
    Rectangle2D getBounds2D();

    /** Whether the point is inside. */
    boolean contains(double x, double y);

    /** Whether the point is inside. */
    boolean contains(Point2D p);

    /** Whether any inner part of the rectangle belongs to the shape too. */
    boolean intersects(double x, double y, double w, double h);

    /** Whether any inner part of the rectangle belongs to the shape too. */
    boolean intersects(Rectangle2D r);

    /** Whether the whole rectangle is inside. */
    boolean contains(double x, double y, double w, double h);

    /** Whether the whole rectangle is inside. */
    boolean contains(Rectangle2D r);
}
