package brickless.physics;

import java.util.Arrays;
import org.jbox2d.callbacks.ContactImpulse;
import org.jbox2d.callbacks.ContactListener;
import org.jbox2d.collision.Manifold;
import org.jbox2d.collision.WorldManifold;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.contacts.Contact;

/** Turns the solver's contacts into bumper forces, things within a claw's reach, and collisions. */
final class Contacts implements ContactListener {
    /** Bodies must have been apart this long before touching again counts as another collision: assumption. */
    static final long APART_NANOS = 200_000_000;

    private final int[][] touching;
    private final long[][] apartSince;
    private final WorldManifold manifold = new WorldManifold();
    private ArenaListener listener = ArenaListener.NONE;
    private long now;

    Contacts(int robots, int solids) {
        touching = new int[robots][solids];
        apartSince = new long[robots][solids];
        for (long[] row : apartSince) {
            Arrays.fill(row, -APART_NANOS);
        }
    }

    void setListener(ArenaListener listener) {
        this.listener = listener;
    }

    void begin(long nowNanos) {
        now = nowNanos;
    }

    @Override public void beginContact(Contact contact) {
        if (isReach(contact)) {
            reach(contact, 1);
            return;
        }
        bumper(contact.getFixtureA(), true);
        bumper(contact.getFixtureB(), true);
        Solid a = solid(contact.getFixtureA());
        Solid b = solid(contact.getFixtureB());
        if (count(a, b, 1) == 1 && now - apartSince(a, b) >= APART_NANOS) {
            report(contact, a, b);
        }
    }

    @Override public void endContact(Contact contact) {
        if (isReach(contact)) {
            reach(contact, -1);
            return;
        }
        bumper(contact.getFixtureA(), false);
        bumper(contact.getFixtureB(), false);
        count(solid(contact.getFixtureA()), solid(contact.getFixtureB()), -1);
    }

    @Override public void preSolve(Contact contact, Manifold oldManifold) {
        // Contacts are solved as they are.
    }

    @Override public void postSolve(Contact contact, ContactImpulse impulse) {
        double sum = 0;
        for (int i = 0; i < impulse.count; i++) {
            sum += Decimetres.impulse(impulse.normalImpulses[i]);
        }
        if (contact.getFixtureA().getUserData() instanceof Bumper bumper) {
            bumper.push(sum);
        }
        if (contact.getFixtureB().getUserData() instanceof Bumper bumper) {
            bumper.push(sum);
        }
    }

    private static boolean isReach(Contact contact) {
        return contact.getFixtureA().isSensor() || contact.getFixtureB().isSensor();
    }

    private static void reach(Contact contact, int change) {
        reach(contact.getFixtureA(), solid(contact.getFixtureB()), change);
        reach(contact.getFixtureB(), solid(contact.getFixtureA()), change);
    }

    private static void reach(Fixture fixture, Solid other, int change) {
        if (fixture.getUserData() instanceof Gripper gripper && other instanceof ObstacleBody obstacle
                && obstacle.description().movable()) {
            gripper.reach(obstacle, change);
        }
    }

    private static void bumper(Fixture fixture, boolean begins) {
        if (fixture.getUserData() instanceof Bumper bumper) {
            if (begins) {
                bumper.begin();
            } else {
                bumper.end();
            }
        }
    }

    private static Solid solid(Fixture fixture) {
        return (Solid) fixture.getBody().getUserData();
    }

    /** Counts contacts between a robot and another solid; returns the new count, 0 if no robot is involved. */
    private int count(Solid a, Solid b, int change) {
        RobotBody robot = robotOf(a, b);
        if (robot == null) {
            return 0;
        }
        int other = index(robot == a ? b : a);
        touching[robot.index][other] += change;
        if (touching[robot.index][other] == 0) {
            apartSince[robot.index][other] = now;
        }
        return touching[robot.index][other];
    }

    private long apartSince(Solid a, Solid b) {
        RobotBody robot = robotOf(a, b);
        return apartSince[robot.index][index(robot == a ? b : a)];
    }

    /** The robot that keeps the book for a pair: of two robots the one with the lower number. */
    private static RobotBody robotOf(Solid a, Solid b) {
        if (a instanceof RobotBody first && b instanceof RobotBody second) {
            return first.index < second.index ? first : second;
        }
        return a instanceof RobotBody robot ? robot : b instanceof RobotBody robot ? robot : null;
    }

    private int index(Solid solid) {
        return solid instanceof RobotBody robot ? robot.index : touching.length + ((ObstacleBody) solid).index;
    }

    private void report(Contact contact, Solid a, Solid b) {
        contact.getWorldManifold(manifold);
        Vec2 normal = manifold.normal;
        double byA = Decimetres.metres(Vec2.dot(contact.getFixtureA().getBody().m_linearVelocity, normal));
        double byB = -Decimetres.metres(Vec2.dot(contact.getFixtureB().getBody().m_linearVelocity, normal));
        double speed = Math.max(0, byA + byB);
        if (byA >= byB) {
            listener.collision(a, b, speed);
        } else {
            listener.collision(b, a, speed);
        }
    }
}
