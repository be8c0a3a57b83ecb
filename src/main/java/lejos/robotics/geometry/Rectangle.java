package lejos.robotics.geometry;

/** An upright rectangle in single precision. */
public class Rectangle extends Rectangle2D.Float {
    /** A rectangle from its corner of lowest coordinates and its extents. */
    public Rectangle(float x, float y, float width, float height) {
        super(x, y, width, height);
    }
}
