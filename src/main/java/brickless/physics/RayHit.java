package brickless.physics;

/** What a ray met first. Mutable so that casting allocates nothing. */
public final class RayHit {
    private double distance;
    private double incidenceCosine;
    private Solid solid;

    void clear() {
        distance = Double.POSITIVE_INFINITY;
        incidenceCosine = 1;
        solid = null;
    }

    void set(double distanceMetres, double cosineOfIncidence, Solid hit) {
        distance = distanceMetres;
        incidenceCosine = cosineOfIncidence;
        solid = hit;
    }

    /** Distance from the ray's origin in metres, infinite if nothing was met. */
    public double distanceMetres() {
        return distance;
    }

    /** Angle between the ray and the surface normal, 0 (head on) to π/2. */
    public double incidenceRadians() {
        return StrictMath.acos(Math.max(-1, Math.min(1, incidenceCosine)));
    }

    /** What was hit, null if nothing. */
    public Solid solid() {
        return solid;
    }
}
