package lejos.robotics.geometry;

/** A shape described by an upright rectangle around it. */
public abstract class RectangularShape implements Shape, Cloneable {
    /** For subclasses. */
    public RectangularShape() {
    }

    /** Lowest x coordinate. */
    public abstract double getX();

    /** Lowest y coordinate. */
    public abstract double getY();

    /** Extent along x. */
    public abstract double getWidth();

    /** Extent along y. */
    public abstract double getHeight();

    /** Lowest x coordinate. */
    public double getMinX() {
        return getX();
    }

    /** Lowest y coordinate. */
    public double getMinY() {
        return getY();
    }

    /** Highest x coordinate. */
    public double getMaxX() {
        return getX() + getWidth();
    }

    /** Highest y coordinate. */
    public double getMaxY() {
        return getY() + getHeight();
    }

    /** The x coordinate of the centre. */
    public double getCenterX() {
        return getX() + getWidth() / 2;
    }

    /** The y coordinate of the centre. */
    public double getCenterY() {
        return getY() + getHeight() / 2;
    }

    /** The rectangle around the shape, as a new one. */
    public Rectangle2D getFrame() {
        return new Rectangle2D.Double(getX(), getY(), getWidth(), getHeight());
    }

    /** Whether the shape has no area. */
    public abstract boolean isEmpty();

    /** Moves and resizes the shape. */
    public abstract void setFrame(double x, double y, double w, double h);

    /** Moves and resizes the shape. */
    public void setFrame(Rectangle2D r) {
        setFrame(r.getX(), r.getY(), r.getWidth(), r.getHeight());
    }

    @Override
    public boolean contains(Point2D p) {
        return contains(p.getX(), p.getY());
    }

    @Override
    public boolean intersects(Rectangle2D r) {
        return intersects(r.getX(), r.getY(), r.getWidth(), r.getHeight());
    }

    @Override
    public boolean contains(Rectangle2D r) {
        return contains(r.getX(), r.getY(), r.getWidth(), r.getHeight());
    }

    /**
     * The smallest rectangle of whole coordinates that encloses the shape; an empty one if width or height is negative.
     */
    @Override
    public RectangleInt32 getBounds() {
        if (getWidth() < 0 || getHeight() < 0) {
            return new RectangleInt32();
        }
        int left = (int) Math.floor(getX());
        int bottom = (int) Math.floor(getY());
        int right = (int) Math.ceil(getMaxX());
        int top = (int) Math.ceil(getMaxY());
        return new RectangleInt32(left, bottom, right - left, top - bottom);
    }

    @Override
    public Object clone() {
        try {
            return super.clone();
        } catch (CloneNotSupportedException e) {
            throw new AssertionError(e);
        }
    }
}
