package lejos.robotics.geometry;

/** An upright rectangle; {@link Float} and {@link Double} hold its coordinates. Equal when the coordinates are. */
public abstract class Rectangle2D extends RectangularShape {
    /** In an {@link #outcode}: left of the rectangle. */
    public static final int OUT_LEFT = 1;
    /** In an {@link #outcode}: at lower y than the rectangle. */
    public static final int OUT_TOP = 2;
    /** In an {@link #outcode}: right of the rectangle. */
    public static final int OUT_RIGHT = 4;
    /** In an {@link #outcode}: at higher y than the rectangle. */
    public static final int OUT_BOTTOM = 8;

    /** For subclasses. */
    protected Rectangle2D() {
    }

    @Override
    public boolean contains(double x, double y, double w, double h) {
        return !isEmpty() && w > 0 && h > 0
                && x >= getX() && y >= getY() && x + w <= getMaxX() && y + h <= getMaxY();
    }

    /** Moves and resizes the rectangle. */
    public abstract void setRect(double x, double y, double w, double h);

    /** Moves and resizes the rectangle to be like another. */
    public void setRect(Rectangle2D r) {
        setRect(r.getX(), r.getY(), r.getWidth(), r.getHeight());
    }

    @Override
    public void setFrame(double x, double y, double w, double h) {
        setRect(x, y, w, h);
    }

    @Override
    public boolean contains(double x, double y) {
        return x >= getX() && y >= getY() && x < getMaxX() && y < getMaxY();
    }

    @Override
    public boolean intersects(double x, double y, double w, double h) {
        return !isEmpty() && w > 0 && h > 0
                && x + w > getX() && y + h > getY() && x < getMaxX() && y < getMaxY();
    }

    /** Whether the line from 1 to 2 meets the rectangle or its edges. */
    public boolean intersectsLine(double x1, double y1, double x2, double y2) {
        int end = outcode(x2, y2);
        double x = x1;
        double y = y1;
        for (int start = outcode(x, y); start != 0 && end != 0; start = outcode(x, y)) {
            if ((start & end) != 0) {
                return false;
            }
            if ((start & (OUT_LEFT | OUT_RIGHT)) != 0) {
                double edge = (start & OUT_RIGHT) != 0 ? getMaxX() : getX();
                y += (edge - x) * (y2 - y) / (x2 - x);
                x = edge;
            } else {
                double edge = (start & OUT_BOTTOM) != 0 ? getMaxY() : getY();
                x += (edge - y) * (x2 - x) / (y2 - y);
                y = edge;
            }
        }
        return true;
    }

    /** On which sides of the rectangle a point lies: a sum of the constants, 0 = inside or on an edge. */
    public int outcode(Point2D p) {
        return outcode(p.getX(), p.getY());
    }

    /** On which sides of the rectangle a point lies: a sum of the constants, 0 = inside or on an edge. */
    public abstract int outcode(double x, double y);

    /** Whether the other is a rectangle of the same coordinates, however it holds them. */
    @Override
    public boolean equals(Object obj) {
        return obj instanceof Rectangle2D other && getX() == other.getX() && getY() == other.getY()
                && getWidth() == other.getWidth() && getHeight() == other.getHeight();
    }

    @Override
    public int hashCode() {
        return Coordinates.hash(getX(), getY(), getWidth(), getHeight());
    }

    /** The outcode; a rectangle without extent has every point on both sides of it. */
    final int outcodeOf(double x, double y) {
        return side(x, getX(), getWidth(), OUT_LEFT, OUT_RIGHT) | side(y, getY(), getHeight(), OUT_TOP, OUT_BOTTOM);
    }

    private static int side(double value, double from, double extent, int below, int above) {
        if (extent <= 0) {
            return below | above;
        }
        if (value < from) {
            return below;
        }
        return value > from + extent ? above : 0;
    }

    /** A rectangle with coordinates in single precision. */
    public static class Float extends Rectangle2D {
        /** Lowest x coordinate. */
        public float x;
        /** Lowest y coordinate. */
        public float y;
        /** Extent along x. */
        public float width;
        /** Extent along y. */
        public float height;

        /** An empty rectangle at the origin. */
        public Float() {
        }

        /** A rectangle. */
        public Float(float x, float y, float width, float height) {
            setRect(x, y, width, height);
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

        @Override
        public boolean isEmpty() {
            return width <= 0 || height <= 0;
        }

        @Override
        public Rectangle2D getBounds2D() {
            return new Float(x, y, width, height);
        }

        /** Moves and resizes the rectangle. */
        public void setRect(float x, float y, float width, float height) {
            this.x = x;
            this.y = y;
            this.width = width;
            this.height = height;
        }

        @Override
        public void setRect(Rectangle2D r) {
            setRect(r.getX(), r.getY(), r.getWidth(), r.getHeight());
        }

        @Override
        public void setRect(double x, double y, double width, double height) {
            setRect((float) x, (float) y, (float) width, (float) height);
        }

        @Override
        public int outcode(double x, double y) {
            return outcodeOf(x, y);
        }
    }

    /** A rectangle with coordinates in double precision. */
    public static class Double extends Rectangle2D {
        /** Lowest x coordinate. */
        public double x;
        /** Lowest y coordinate. */
        public double y;
        /** Extent along x. */
        public double width;
        /** Extent along y. */
        public double height;

        /** An empty rectangle at the origin. */
        public Double() {
        }

        /** A rectangle. */
        public Double(double x, double y, double width, double height) {
            setRect(x, y, width, height);
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

        @Override
        public boolean isEmpty() {
            return width <= 0 || height <= 0;
        }

        @Override
        public void setFrame(double x, double y, double width, double height) {
            setRect(x, y, width, height);
        }

        @Override
        public Rectangle2D getBounds2D() {
            return new Double(x, y, width, height);
        }

        @Override
        public void setRect(double x, double y, double width, double height) {
            this.x = x;
            this.y = y;
            this.width = width;
            this.height = height;
        }

        @Override
        public void setRect(Rectangle2D r) {
            setRect(r.getX(), r.getY(), r.getWidth(), r.getHeight());
        }

        @Override
        public int outcode(double x, double y) {
            return outcodeOf(x, y);
        }
    }
}
