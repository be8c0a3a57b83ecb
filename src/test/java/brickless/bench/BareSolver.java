package brickless.bench;

import brickless.world.Point2;
import java.util.ArrayList;
import java.util.List;
import org.jbox2d.callbacks.RayCastCallback;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.dynamics.joints.FrictionJointDef;

/**
 * The yardstick: JBox2D alone, as it comes, with the bodies, moves and rays of {@link DrivingRobots}, and nothing else.
 * Robots are pushed along their circles by setting their velocities. Lengths are decimetres.
 */
final class BareSolver extends StepCost {
    private static final float STEP_SECONDS = 0.002f;
    private static final long PING_NANOS = 25_000_000;
    private static final int RAYS = 9;
    private static final float RAY_SPACING = (float) Math.toRadians(30.0 / (RAYS - 1));
    private static final float REACH = 25.5f;
    private static final float SPEED = 1.5f;
    private static final float SPIN = 0.6f;

    private final Nearest nearest = new Nearest();
    private World world;
    private Body ground;

    BareSolver(int robots) {
        super(robots);
    }

    @Override
    Stepper stepper() {
        RobotGrid grid = new RobotGrid(robots());
        world = new World(new Vec2(0, 0));
        world.setContinuousPhysics(false);
        ground = world.createBody(new BodyDef());
        float side = (float) grid.side() * 10;
        float wall = (float) RobotGrid.WALL * 10;
        wall(side / 2, -wall / 2, side / 2, wall / 2);
        wall(side / 2, side + wall / 2, side / 2, wall / 2);
        wall(-wall / 2, side / 2, wall / 2, side / 2);
        wall(side + wall / 2, side / 2, wall / 2, side / 2);
        List<Body> robots = new ArrayList<>();
        for (int i = 0; i < robots(); i++) {
            Point2 place = grid.place(i);
            crate((float) (place.x() + RobotGrid.CRATE_AWAY) * 10, (float) (place.y() + RobotGrid.CRATE_AWAY) * 10);
            robots.add(robot((float) place.x() * 10, (float) place.y() * 10));
        }
        return time -> step(robots, time);
    }

    private void step(List<Body> robots, long time) {
        for (int i = 0; i < robots.size(); i++) {
            Body robot = robots.get(i);
            robot.m_linearVelocity.set(SPEED * (float) StrictMath.cos(robot.getAngle()),
                    SPEED * (float) StrictMath.sin(robot.getAngle()));
            robot.m_angularVelocity = SPIN;
        }
        world.step(STEP_SECONDS, 6, 2);
        if (time / PING_NANOS != (time - 2_000_000) / PING_NANOS) {
            for (int i = 0; i < robots.size(); i++) {
                look(robots.get(i));
            }
        }
    }

    private void look(Body robot) {
        for (int i = 0; i < RAYS; i++) {
            float angle = robot.getAngle() + (i - RAYS / 2) * RAY_SPACING;
            nearest.cast(robot, angle);
        }
    }

    private void wall(float x, float y, float halfWidth, float halfHeight) {
        Body body = body(BodyType.STATIC, x, y);
        box(body, 0, 0, halfWidth, halfHeight, 0);
    }

    private void crate(float x, float y) {
        Body body = body(BodyType.DYNAMIC, x, y);
        float half = (float) RobotGrid.CRATE * 5;
        box(body, 0, 0, half, half, (float) RobotGrid.CRATE_KILOGRAMS / (4 * half * half));
        rub(body, 20, 10);
    }

    private Body robot(float x, float y) {
        Body body = body(BodyType.DYNAMIC, x, y);
        box(body, -0.3f, 0, 0.8f, 0.7f, 0.8f / (1.6f * 1.4f));
        box(body, 0.6f, 0, 0.05f, 0.58f, 0);
        rub(body, 1, 0.5f);
        return body;
    }

    private Body body(BodyType type, float x, float y) {
        BodyDef definition = new BodyDef();
        definition.type = type;
        definition.position.set(x, y);
        return world.createBody(definition);
    }

    private static void box(Body body, float x, float y, float halfWidth, float halfHeight, float density) {
        PolygonShape shape = new PolygonShape();
        shape.setAsBox(halfWidth, halfHeight, new Vec2(x, y), 0);
        FixtureDef fixture = new FixtureDef();
        fixture.shape = shape;
        fixture.density = density;
        body.createFixture(fixture);
    }

    private void rub(Body body, float force, float torque) {
        FrictionJointDef joint = new FrictionJointDef();
        joint.initialize(ground, body, body.getWorldCenter());
        joint.collideConnected = true;
        joint.maxForce = force;
        joint.maxTorque = torque;
        world.createJoint(joint);
    }

    /** The first body a ray meets, other than the robot it starts at. */
    private final class Nearest implements RayCastCallback {
        private final Vec2 from = new Vec2();
        private final Vec2 to = new Vec2();
        private Body self;

        void cast(Body robot, float angle) {
            self = robot;
            from.set(robot.getPosition());
            to.set(from.x + REACH * (float) StrictMath.cos(angle), from.y + REACH * (float) StrictMath.sin(angle));
            world.raycast(this, from, to);
        }

        @Override
        public float reportFixture(Fixture fixture, Vec2 point, Vec2 normal, float fraction) {
            return fixture.getBody() == self ? -1 : fraction;
        }
    }
}
