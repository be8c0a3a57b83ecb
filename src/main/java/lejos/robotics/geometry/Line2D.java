package lejos.robotics.geometry;

/** A straight line between two points; {@link Float} and {@link Double} hold their coordinates. It has no inside. */
public abstract class Line2D implements Shape, Cloneable {
    /** For subclasses. */
    protected Line2D() {
    }

    /** The x coordinate of the first end. */
    public abstract double getX1();

    /** The y coordinate of the first end. */
    public abstract double getY1();

    /** The first end, as a new point. */
    public abstract Point2D getP1();

    /** The x coordinate of the second end. */
    public abstract double getX2();

    /** The y coordinate of the second end. */
    public abstract double getY2();

    /** The second end, as a new point. */
    public abstract Point2D getP2();

    /** Moves both ends. */
    public abstract void setLine(double x1, double y1, double x2, double y2);

    /** Moves both ends. */
    public void setLine(Point2D p1, Point2D p2) {
        setLine(p1.getX(), p1.getY(), p2.getX(), p2.getY());
    }

    /** Moves both ends to where those of another line are. */
    public void setLine(Line2D l) {
        setLine(l.getX1(), l.getY1(), l.getX2(), l.getY2());
    }

    /** Always false: a line has no inside. */
    @Override
    public boolean contains(double x, double y) {
        return false;
    }

    /** Always false: a line has no inside. */
    @Override
    public boolean contains(Point2D p) {
        return false;
    }

    /** Always false: a line has no inside. */
    @Override
    public boolean contains(double x, double y, double w, double h) {
        return false;
    }

    /** Always false: a line has no inside. */
    @Override
    public boolean contains(Rectangle2D r) {
        return false;
    }

    /** Whether the line meets the rectangle or its edges. */
    @Override
    public boolean intersects(double x, double y, double w, double h) {
        return intersects(new Rectangle2D.Double(x, y, w, h));
    }

    /** Whether the line meets the rectangle or its edges. */
    @Override
    public boolean intersects(Rectangle2D r) {
        return r.intersectsLine(getX1(), getY1(), getX2(), getY2());
    }

    /** Whether this line and another have a point in common, ends included. */
    public boolean intersectsLine(double x1, double y1, double x2, double y2) {
        return linesIntersect(x1, y1, x2, y2, getX1(), getY1(), getX2(), getY2());
    }

    /** Whether this line and another have a point in common, ends included. */
    public boolean intersectsLine(Line2D l) {
        return intersectsLine(l.getX1(), l.getY1(), l.getX2(), l.getY2());
    }

    /** Whether the line 1–2 and the line 3–4 have a point in common, ends included. */
    public static boolean linesIntersect(double x1, double y1, double x2, double y2,
            double x3, double y3, double x4, double y4) {
        boolean endsOfSecondApart = relativeCCW(x1, y1, x2, y2, x3, y3) * relativeCCW(x1, y1, x2, y2, x4, y4) <= 0;
        boolean endsOfFirstApart = relativeCCW(x3, y3, x4, y4, x1, y1) * relativeCCW(x3, y3, x4, y4, x2, y2) <= 0;
        return endsOfSecondApart && endsOfFirstApart;
    }

    @Override
    public RectangleInt32 getBounds() {
        return getBounds2D().getBounds();
    }

    @Override
    public Object clone() {
        try {
            return super.clone();
        } catch (CloneNotSupportedException e) {
            throw new AssertionError(e);
        }
    }

    /**
     * On which side of the line 1–2 a point lies.
     *
     * @return with y up: −1 to the left of the way from 1 to 2, 1 to the right; on the straight line itself −1 before
     *     point 1, 1 beyond point 2, 0 between
     */
    public static int relativeCCW(double x1, double y1, double x2, double y2, double px, double py) {
        double dx = x2 - x1;
        double dy = y2 - y1;
        double side = (px - x1) * dy - (py - y1) * dx;
        if (side != 0) {
            return side < 0 ? -1 : 1;
        }
        double along = (px - x1) * dx + (py - y1) * dy;
        if (along < 0) {
            return -1;
        }
        double beyond = (px - x1 - dx) * dx + (py - y1 - dy) * dy;
        return along > 0 && beyond > 0 ? 1 : 0;
    }

    /** On which side a point lies; see {@link #relativeCCW(double, double, double, double, double, double)}. */
    public int relativeCCW(Point2D p) {
        return relativeCCW(p.getX(), p.getY());
    }

    /** On which side a point lies; see {@link #relativeCCW(double, double, double, double, double, double)}. */
    public int relativeCCW(double px, double py) {
        return relativeCCW(getX1(), getY1(), getX2(), getY2(), px, py);
    }

    /** Square of the distance from a point to the nearest point of the line 1–2. */
    public static double ptSegDistSq(double x1, double y1, double x2, double y2, double px, double py) {
        double dx = x2 - x1;
        double dy = y2 - y1;
        double along = (px - x1) * dx + (py - y1) * dy;
        if (along <= 0) {
            return Point2D.distanceSq(x1, y1, px, py);
        }
        double lengthSq = dx * dx + dy * dy;
        if (along >= lengthSq) {
            return Point2D.distanceSq(x2, y2, px, py);
        }
        double across = (px - x1) * dy - (py - y1) * dx;
        return across * across / lengthSq;
    }

    /** Distance from a point to the nearest point of the line 1–2. */
    public static double ptSegDist(double x1, double y1, double x2, double y2, double px, double py) {
        return Math.sqrt(ptSegDistSq(x1, y1, x2, y2, px, py));
    }

    /** Square of the distance from a point to the nearest point of this line. */
    public double ptSegDistSq(double px, double py) {
        return ptSegDistSq(getX1(), getY1(), getX2(), getY2(), px, py);
    }

    /** Square of the distance from a point to the nearest point of this line. */
    public double ptSegDistSq(Point2D pt) {
        return ptSegDistSq(pt.getX(), pt.getY());
    }

    /** Distance from a point to the nearest point of this line. */
    public double ptSegDist(double px, double py) {
        return Math.sqrt(ptSegDistSq(px, py));
    }

    /** Distance from a point to the nearest point of this line. */
    public double ptSegDist(Point2D pt) {
        return ptSegDist(pt.getX(), pt.getY());
    }

    /** A line with coordinates in single precision. */
    public static class Float extends Line2D {
        /** The x coordinate of the first end. */
        public float x1;
        /** The y coordinate of the first end. */
        public float y1;
        /** The x coordinate of the second end. */
        public float x2;
        /** The y coordinate of the second end. */
        public float y2;

        /** A line without length at the origin. */
        public Float() {
        }

        /** A line. */
        public Float(float x1, float y1, float x2, float y2) {
            setLine(x1, y1, x2, y2);
        }

        /** Moves both ends. */
        public void setLine(float x1, float y1, float x2, float y2) {
            this.x1 = x1;
            this.y1 = y1;
            this.x2 = x2;
            this.y2 = y2;
        }

        @Override
        public void setLine(double x1, double y1, double x2, double y2) {
            setLine((float) x1, (float) y1, (float) x2, (float) y2);
        }

        @Override
        public Rectangle2D getBounds2D() {
            float left = Math.min(x1, x2);
            float bottom = Math.min(y1, y2);
            return new Rectangle2D.Float(left, bottom, Math.max(x1, x2) - left, Math.max(y1, y2) - bottom);
        }

        @Override
        public double getX1() {
            return x1;
        }

        @Override
        public double getY1() {
            return y1;
        }

        @Override
        public Point2D getP1() {
            return new Point2D.Float(x1, y1);
        }

        @Override
        public double getX2() {
            return x2;
        }

        @Override
        public double getY2() {
            return y2;
        }

        @Override
        public Point2D getP2() {
            return new Point2D.Float(x2, y2);
        }
    }

    /** A line with coordinates in double precision. */
    public static class Double extends Line2D {
        /** The x coordinate of the first end. */
        public double x1;
        /** The y coordinate of the first end. */
        public double y1;
        /** The x coordinate of the second end. */
        public double x2;
        /** The y coordinate of the second end. */
        public double y2;

        /** A line without length at the origin. */
        public Double() {
        }

        /** A line. */
        public Double(double x1, double y1, double x2, double y2) {
            setLine(x1, y1, x2, y2);
        }

        @Override
        public double getX1() {
            return x1;
        }

        @Override
        public double getY1() {
            return y1;
        }

        @Override
        public Point2D getP1() {
            return new Point2D.Double(x1, y1);
        }

        @Override
        public double getX2() {
            return x2;
        }

        @Override
        public double getY2() {
            return y2;
        }

        @Override
        public Point2D getP2() {
            return new Point2D.Double(x2, y2);
        }

        @Override
        public void setLine(double x1, double y1, double x2, double y2) {
            this.x1 = x1;
            this.y1 = y1;
            this.x2 = x2;
            this.y2 = y2;
        }

        @Override
        public Rectangle2D getBounds2D() {
            double left = Math.min(x1, x2);
            double bottom = Math.min(y1, y2);
            return new Rectangle2D.Double(left, bottom, Math.max(x1, x2) - left, Math.max(y1, y2) - bottom);
        }
    }
}
