package lejos.robotics.geometry;

/** A point in the plane; {@link Float} and {@link Double} hold its coordinates. Equal when the coordinates are. */
public abstract class Point2D implements Cloneable {
    /** For subclasses. */
    protected Point2D() {
    }

    /** The x coordinate. */
    public abstract double getX();

    /** The y coordinate. */
    public abstract double getY();

    /** Moves the point. */
    public abstract void setLocation(double x, double y);

    /** Moves the point to where another is. */
    public void setLocation(Point2D p) {
        setLocation(p.getX(), p.getY());
    }

    /** Square of the distance between two points. */
    public static double distanceSq(double x1, double y1, double x2, double y2) {
        double dx = x2 - x1;
        double dy = y2 - y1;
        return dx * dx + dy * dy;
    }

    /** Distance between two points. */
    public static double distance(double x1, double y1, double x2, double y2) {
        return Math.sqrt(distanceSq(x1, y1, x2, y2));
    }

    /** Square of the distance to a point. */
    public double distanceSq(double px, double py) {
        return distanceSq(getX(), getY(), px, py);
    }

    /** Square of the distance to a point. */
    public double distanceSq(Point2D pt) {
        return distanceSq(pt.getX(), pt.getY());
    }

    /** Distance to a point. */
    public double distance(double px, double py) {
        return Math.sqrt(distanceSq(px, py));
    }

    /** Distance to a point. */
    public double distance(Point2D pt) {
        return distance(pt.getX(), pt.getY());
    }

    /** Whether the other is a point of the same coordinates, however it holds them. */
    @Override
    public boolean equals(Object obj) {
        return obj instanceof Point2D other && getX() == other.getX() && getY() == other.getY();
    }

    @Override
    public int hashCode() {
        return Coordinates.hash(getX(), getY());
    }

    @Override
    public Object clone() {
        try {
            return super.clone();
        } catch (CloneNotSupportedException e) {
            throw new AssertionError(e);
        }
    }

    /** A point with coordinates in single precision. */
    public static class Float extends Point2D {
        /** The x coordinate. */
        public float x;
        /** The y coordinate. */
        public float y;

        /** The origin. */
        public Float() {
        }

        /** A point. */
        public Float(float x, float y) {
            this.x = x;
            this.y = y;
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
        public void setLocation(double x, double y) {
            this.x = (float) x;
            this.y = (float) y;
        }

        /** Moves the point. */
        public void setLocation(float x, float y) {
            this.x = x;
            this.y = y;
        }

        @Override
        public String toString() {
            return "Point2D.Float[" + x + ", " + y + "]";
        }
    }

    /** A point with coordinates in double precision. */
    public static class Double extends Point2D {
        /** The x coordinate. */
        public double x;
        /** The y coordinate. */
        public double y;

        /** The origin. */
        public Double() {
        }

        /** A point. */
        public Double(double x, double y) {
            this.x = x;
            this.y = y;
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
        public void setLocation(double x, double y) {
            this.x = x;
            this.y = y;
        }

        @Override
        public String toString() {
            return "Point2D.Double[" + x + ", " + y + "]";
        }
    }
}
