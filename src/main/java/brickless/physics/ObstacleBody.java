package brickless.physics;

import brickless.world.Obstacle;
import brickless.world.Point2;
import brickless.world.Pose2;
import java.util.List;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.joints.FrictionJointDef;

/** Something solid in the arena. Movable ones slide over the floor with Coulomb friction. */
public final class ObstacleBody implements Solid {
    /** m/s². */
    static final double GRAVITY = 9.81;
    /** Lightest movable body, kg: lighter ones would only upset the solver. */
    private static final double LEAST_MASS = 1e-3;
    /**
     * Mean distance from the centre of the points of a disc, in radii: the lever arm of friction that resists turning.
     */
    private static final double FRICTION_ARM = 2.0 / 3;

    final Body body;
    private final Obstacle description;
    private final Point2 centre;
    private final double radius;

    ObstacleBody(org.jbox2d.dynamics.World world, Body ground, Obstacle description) {
        this.description = description;
        List<List<Point2>> pieces = Shapes.pieces(description.outlines());
        this.centre = Shapes.centroid(pieces);
        this.radius = Shapes.radius(pieces, centre);
        BodyDef definition = new BodyDef();
        definition.type = description.movable() ? BodyType.DYNAMIC : BodyType.STATIC;
        definition.position.set(Decimetres.of(centre.x()), Decimetres.of(centre.y()));
        body = world.createBody(definition);
        body.setUserData(this);
        double area = Shapes.area(pieces);
        double mass = Math.max(LEAST_MASS, description.massKilograms());
        FixtureDef fixture = new FixtureDef();
        fixture.friction = (float) description.friction();
        fixture.density = description.movable() && area > 0
                ? (float) (mass / (area * Decimetres.PER_METRE * Decimetres.PER_METRE)) : 0;
        Shapes.attach(body, pieces, centre, fixture);
        if (description.movable()) {
            restOn(ground, mass, StrictMath.sqrt(area / StrictMath.PI));
        }
    }

    private void restOn(Body ground, double mass, double radius) {
        FrictionJointDef joint = new FrictionJointDef();
        joint.initialize(ground, body, body.getWorldCenter());
        joint.collideConnected = true;
        double force = description.friction() * mass * GRAVITY;
        joint.maxForce = Decimetres.force(force);
        joint.maxTorque = Decimetres.torque(force * radius * FRICTION_ARM);
        body.getWorld().createJoint(joint);
    }

    @Override
    public String name() {
        return description.id();
    }

    /** What was drawn. */
    public Obstacle description() {
        return description;
    }

    /** Whether it can be pushed. */
    public boolean movable() {
        return description.movable();
    }

    /** Whether it is not exactly where it was drawn. */
    public boolean displaced() {
        return body.getAngle() != 0 || body.getPosition().x != Decimetres.of(centre.x())
                || body.getPosition().y != Decimetres.of(centre.y());
    }

    /** False once removed. */
    public boolean present() {
        return body.isActive();
    }

    /**
     * How the obstacle has moved since the start: drawn points turned by the heading about the drawing's origin, then
     * shifted, give their present place (the arguments of an SVG {@code translate} and {@code rotate}).
     */
    public Pose2 displacement() {
        double angle = body.getAngle();
        double cos = StrictMath.cos(angle);
        double sin = StrictMath.sin(angle);
        double x = Decimetres.metres(body.getPosition().x);
        double y = Decimetres.metres(body.getPosition().y);
        return new Pose2(x - (cos * centre.x() - sin * centre.y()), y - (sin * centre.x() + cos * centre.y()), angle);
    }

    /** Present x of the centroid, metres. */
    public double centreX() {
        return Decimetres.metres(body.getPosition().x);
    }

    /** Present y of the centroid, metres. */
    public double centreY() {
        return Decimetres.metres(body.getPosition().y);
    }

    /** Distance of its farthest point from the centroid, metres. */
    public double radiusMetres() {
        return radius;
    }

    /** Present place of the centroid. */
    public Point2 centre() {
        return new Point2(centreX(), centreY());
    }

    /** Kinetic energy, joules. */
    public double kineticEnergyJoules() {
        double vx = Decimetres.metres(body.m_linearVelocity.x);
        double vy = Decimetres.metres(body.m_linearVelocity.y);
        double spin = body.m_angularVelocity;
        return (body.m_mass * (vx * vx + vy * vy) + Decimetres.inertia(body.m_I) * spin * spin) / 2;
    }

    void place(Pose2 pose) {
        body.setTransform(new Vec2(Decimetres.of(pose.x()), Decimetres.of(pose.y())), (float) pose.headingRadians());
        body.setLinearVelocity(new Vec2());
        body.setAngularVelocity(0);
        body.setAwake(true);
    }

    void remove() {
        body.setActive(false);
    }
}
