package brickless.physics;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
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

    private final List<List<Meeting>> meetings;
    private final WorldManifold manifold = new WorldManifold();
    private ArenaListener listener = ArenaListener.NONE;
    private long now;

    /** A robot and something that it has touched at some time. */
    private static final class Meeting {
        private final Solid other;
        private int contacts;
        private long apartSince = -APART_NANOS;

        Meeting(Solid other) {
            this.other = other;
        }
    }

    Contacts(int robots) {
        meetings = Stream.generate(() -> (List<Meeting>) new ArrayList<Meeting>()).limit(robots).toList();
    }

    void setListener(ArenaListener listener) {
        this.listener = listener;
    }

    void begin(long nowNanos) {
        now = nowNanos;
    }

    @Override
    public void beginContact(Contact contact) {
        if (isReach(contact)) {
            reach(contact, 1);
            return;
        }
        bumper(contact.getFixtureA(), true);
        bumper(contact.getFixtureB(), true);
        Solid a = solid(contact.getFixtureA());
        Solid b = solid(contact.getFixtureB());
        Meeting meeting = meeting(a, b);
        if (meeting != null && ++meeting.contacts == 1 && now - meeting.apartSince >= APART_NANOS) {
            report(contact, a, b);
        }
    }

    @Override
    public void endContact(Contact contact) {
        if (isReach(contact)) {
            reach(contact, -1);
            return;
        }
        bumper(contact.getFixtureA(), false);
        bumper(contact.getFixtureB(), false);
        Meeting meeting = meeting(solid(contact.getFixtureA()), solid(contact.getFixtureB()));
        if (meeting != null && --meeting.contacts == 0) {
            meeting.apartSince = now;
        }
    }

    @Override
    public void preSolve(Contact contact, Manifold oldManifold) {
        // Contacts are solved as they are.
    }

    @Override
    public void postSolve(Contact contact, ContactImpulse impulse) {
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

    /** The book on a robot and another solid, null if no robot is involved. */
    private Meeting meeting(Solid a, Solid b) {
        RobotBody robot = robotOf(a, b);
        if (robot == null) {
            return null;
        }
        Solid other = robot == a ? b : a;
        List<Meeting> known = meetings.get(robot.index);
        for (int i = 0; i < known.size(); i++) {
            if (known.get(i).other == other) {
                return known.get(i);
            }
        }
        Meeting first = new Meeting(other);
        known.add(first);
        return first;
    }

    /** The robot that keeps the book for a pair: of two robots the one with the lower number. */
    private static RobotBody robotOf(Solid a, Solid b) {
        if (a instanceof RobotBody first && b instanceof RobotBody second) {
            return first.index < second.index ? first : second;
        }
        return a instanceof RobotBody robot ? robot : b instanceof RobotBody robot ? robot : null;
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
