package lejos.robotics.geometry;

/** An upright rectangle of whole coordinates. */
public class RectangleInt32 extends Rectangle2D {
    /** Extent along y. */
    public int height;
    /** Extent along x. */
    public int width;
    /** Lowest x coordinate. */
    public int x;
    /** Lowest y coordinate. */
    public int y;

    /** A rectangle. */
    public RectangleInt32(int x, int y, int width, int height) {
        setBounds(x, y, width, height);
    }

    /** A rectangle at the origin. */
    public RectangleInt32(int width, int height) {
        this(0, 0, width, height);
    }

    /** An empty rectangle at the origin. */
    public RectangleInt32() {
        this(0, 0, 0, 0);
    }

    /** An empty rectangle at a point, whose coordinates lose their fractions. */
    public RectangleInt32(Point p) {
        this((int) p.x, (int) p.y, 0, 0);
    }

    @Override
    public double getX() {
        return x;
    }

    @Override
    public double getY() {
        return y;
    }

    @Override
    public double getWidth() {
        return width;
    }

    @Override
    public double getHeight() {
        return height;
    }

    /** Moves the rectangle. */
    public void setLocation(int x, int y) {
        this.x = x;
        this.y = y;
    }

    /** Moves the rectangle to a point, whose coordinates lose their fractions. */
    public void setLocation(Point p) {
        setLocation((int) p.x, (int) p.y);
    }

    @Override
    public boolean isEmpty() {
        return width <= 0 || height <= 0;
    }

    /** Whether the point is inside. */
    public boolean contains(int x, int y) {
        return contains((double) x, (double) y);
    }

    /** Whether the point is inside. */
    public boolean contains(Point p) {
        return contains(p.getX(), p.getY());
    }

    /**
     * Whether the other has an area and both its corners are inside. A corner on the far edges is not, so a rectangle
     * does not contain itself.
     */
    public boolean contains(RectangleInt32 r) {
        return !r.isEmpty() && contains(r.x, r.y) && contains(r.x + r.width, r.y + r.height);
    }

    /** Whether the two have an area in common. */
    public boolean intersects(RectangleInt32 r) {
        return intersects((double) r.x, (double) r.y, (double) r.width, (double) r.height);
    }

    @Override
    public RectangleInt32 getBounds() {
        return new RectangleInt32(x, y, width, height);
    }

    @Override
    public Rectangle2D getBounds2D() {
        return new RectangleInt32(x, y, width, height);
    }

    /** Moves and resizes the rectangle. */
    public void setBounds(int x, int y, int width, int height) {
        this.x = x;
        this.y = y;
        this.width = width;
        this.height = height;
    }

    /** Moves and resizes the rectangle to be like another. */
    public void setBounds(RectangleInt32 r) {
        setBounds(r.x, r.y, r.width, r.height);
    }

    /**
     * Moves and resizes the rectangle to the smallest one of whole coordinates that encloses the given one. Negative
     * extents are rounded down.
     */
    @Override
    public void setRect(double x, double y, double width, double height) {
        setBounds((int) Math.floor(x), (int) Math.floor(y), enclosing(x, width), enclosing(y, height));
    }

    private static int enclosing(double from, double extent) {
        return (int) (extent < 0 ? Math.floor(extent) : Math.ceil(from + extent) - Math.floor(from));
    }

    /** As {@link #setBounds(int, int, int, int)}. */
    @Deprecated
    public void reshape(int x, int y, int width, int height) {
        setBounds(x, y, width, height);
    }

    @Override
    public boolean equals(Object obj) {
        return super.equals(obj);
    }

    @Override
    public int hashCode() {
        return super.hashCode();
    }

    /** The corner of lowest coordinates, as a new point. */
    public Point getLocation() {
        return new Point(x, y);
    }

    /** Resizes the rectangle. */
    public void setSize(int width, int height) {
        this.width = width;
        this.height = height;
    }

    /** As {@link #setSize}. */
    @Deprecated
    public void resize(int width, int height) {
        setSize(width, height);
    }

    @Override
    public String toString() {
        return "Rectangle[x=" + x + ",y=" + y + ",width=" + width + ",height=" + height + "]";
    }

    @Override
    public int outcode(double x, double y) {
        return outcodeOf(x, y);
    }

    /** As {@link #contains(int, int)}. */
    @Deprecated
    public boolean inside(int x, int y) {
        return contains(x, y);
    }
}
