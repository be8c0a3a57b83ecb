package brickless.physics;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jbox2d.callbacks.TreeCallback;
import org.jbox2d.collision.AABB;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.Island;
import org.jbox2d.dynamics.Profile;
import org.jbox2d.dynamics.TimeStep;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.contacts.ContactEdge;
import org.jbox2d.dynamics.joints.Joint;
import org.jbox2d.dynamics.joints.JointEdge;
import org.jbox2d.pooling.normal.DefaultWorldPool;

/**
 * JBox2D's world with a shorter way through a step. The results are the same, bit for bit (LeanWorldTest).
 *
 * <p>JBox2D reads the host's clock fourteen times in a step to keep a profile, which takes as long as solving one
 * robot. And it treats every body as part of an island of bodies that touch; most of the time a robot touches nothing
 * and {@link FreeMotion} will do. There is no gravity, nobody applies forces, and continuous collision detection is not
 * used.
 */
final class LeanWorld extends org.jbox2d.dynamics.World {
    private static final Vec2 NO_GRAVITY = new Vec2(0, 0);
    /** Of a body: awake, active, and not yet part of an island. */
    private static final int MOVING = Body.e_awakeFlag | Body.e_activeFlag;

    private final TimeStep step = new TimeStep();
    private final Island island = new Island();
    private final Profile profile = new Profile();
    private final FreeMotion free = new FreeMotion();
    private final FatBoxes boxes;
    private final LazyTree tree;
    private Body[] movable = new Body[0];
    private int listedBodies;
    private Body[] stack = new Body[0];
    private Fixture[] fixtures = new Fixture[0];
    private int fixturesVersion = -1;
    private float lastInverse;
    /** Whether bodies were solved together in this step. */
    private boolean islands;

    LeanWorld() {
        this(new LazyTree());
    }

    private LeanWorld(LazyTree tree) {
        super(NO_GRAVITY, new DefaultWorldPool(WORLD_POOL_SIZE, WORLD_POOL_CONTAINER_SIZE), tree);
        this.tree = tree;
        boxes = new FatBoxes(tree, m_contactManager.m_broadPhase);
        setContinuousPhysics(false);
    }

    @Override
    public void step(float seconds, int velocityIterations, int positionIterations) {
        if ((m_flags & NEW_FIXTURE) != 0) {
            m_contactManager.findNewContacts();
            m_flags &= ~NEW_FIXTURE;
        }
        m_flags |= LOCKED;
        step.dt = seconds;
        step.inv_dt = 1 / seconds;
        step.dtRatio = lastInverse * seconds;
        step.velocityIterations = velocityIterations;
        step.positionIterations = positionIterations;
        step.warmStarting = true;
        m_contactManager.collide();
        solve();
        m_contactManager.findNewContacts();
        lastInverse = step.inv_dt;
        m_flags &= ~LOCKED;
    }

    /** Tells about the shapes whose boxes overlap with a box, by their proxies' numbers. */
    void find(TreeCallback callback, AABB box) {
        if (fixturesVersion != tree.version()) {
            listFixtures();
        }
        tree.query(callback, box);
    }

    /** The box around the shape with a proxy number. */
    AABB fatBox(int proxy) {
        return tree.getFatAABB(proxy);
    }

    /** The shape with a proxy number. */
    Fixture fixture(int proxy) {
        return fixtures[proxy];
    }

    private void listFixtures() {
        fixturesVersion = tree.version();
        for (Body body = getBodyList(); body != null; body = body.m_next) {
            for (Fixture fixture = body.m_fixtureList; fixture != null; fixture = fixture.m_next) {
                if (fixture.m_proxyCount > 0) {
                    int proxy = tree.proxyOf(fixture.m_proxies[0]);
                    if (proxy >= fixtures.length) {
                        fixtures = Arrays.copyOf(fixtures, 2 * proxy + 16);
                    }
                    fixtures[proxy] = fixture;
                }
            }
        }
    }

    private void solve() {
        forgetIslands();
        if (listedBodies != getBodyCount()) {
            listBodies();
        }
        for (Body seed : movable) {
            if ((seed.m_flags & (Body.e_islandFlag | Body.e_awakeFlag | Body.e_activeFlag)) == MOVING) {
                Drivetrain alone = alone(seed);
                if (alone != null) {
                    seed.m_flags |= Body.e_islandFlag;
                    free.add(seed, alone, step);
                } else {
                    solveIsland(seed);
                }
            }
        }
        free.finish(step);
        for (Body body : movable) {
            if ((body.m_flags & Body.e_islandFlag) != 0) {
                body.m_flags &= ~Body.e_islandFlag;
                boxes.follow(body);
            }
        }
    }

    /** Bodies that can move, in JBox2D's order; none is ever taken out of the world. */
    private void listBodies() {
        List<Body> found = new ArrayList<>();
        for (Body body = getBodyList(); body != null; body = body.m_next) {
            if (body.m_type != BodyType.STATIC) {
                found.add(body);
            }
        }
        movable = found.toArray(Body[]::new);
        listedBodies = getBodyCount();
    }

    /** Takes the marks of the last step's islands away, if there were any; bodies have lost theirs already. */
    private void forgetIslands() {
        if (!islands) {
            return;
        }
        islands = false;
        for (Contact contact = getContactList(); contact != null; contact = contact.m_next) {
            contact.m_flags &= ~Contact.ISLAND_FLAG;
        }
        for (Joint joint = getJointList(); joint != null; joint = joint.m_next) {
            joint.m_islandFlag = false;
        }
    }

    /** The drivetrain of a robot that touches nothing and carries and pulls nothing; null for other bodies. */
    private static Drivetrain alone(Body body) {
        JointEdge edge = body.m_jointList;
        if (edge == null || edge.next != null || !(edge.joint instanceof Drivetrain drivetrain)) {
            return null;
        }
        for (ContactEdge contact = body.m_contactList; contact != null; contact = contact.next) {
            if (solid(contact.contact)) {
                return null;
            }
        }
        return drivetrain;
    }

    private static boolean solid(Contact contact) {
        return contact.isEnabled() && contact.isTouching() && !contact.m_fixtureA.m_isSensor
                && !contact.m_fixtureB.m_isSensor;
    }

    /**
     * Solves a body together with all that it touches or is joined to, directly or through others; found depth first.
     */
    private void solveIsland(Body seed) {
        if (!islands) {
            islands = true;
            island.init(getBodyCount(), getContactCount(), getJointCount(), m_contactManager.m_contactListener);
        }
        if (stack.length < getBodyCount()) {
            stack = new Body[getBodyCount()];
        }
        island.clear();
        int depth = push(seed, 0);
        while (depth > 0) {
            Body body = stack[--depth];
            island.add(body);
            body.setAwake(true);
            if (body.m_type != BodyType.STATIC) {
                depth = pushTouching(body, depth);
                depth = pushJoined(body, depth);
            }
        }
        island.solve(profile, step, NO_GRAVITY, true);
        for (int i = 0; i < island.m_bodyCount; i++) {
            if (island.m_bodies[i].m_type == BodyType.STATIC) {
                island.m_bodies[i].m_flags &= ~Body.e_islandFlag;
            }
        }
    }

    private int pushTouching(Body body, int depth) {
        int top = depth;
        for (ContactEdge edge = body.m_contactList; edge != null; edge = edge.next) {
            if ((edge.contact.m_flags & Contact.ISLAND_FLAG) == 0 && solid(edge.contact)) {
                island.add(edge.contact);
                edge.contact.m_flags |= Contact.ISLAND_FLAG;
                top = push(edge.other, top);
            }
        }
        return top;
    }

    private int pushJoined(Body body, int depth) {
        int top = depth;
        for (JointEdge edge = body.m_jointList; edge != null; edge = edge.next) {
            if (!edge.joint.m_islandFlag && edge.other.isActive()) {
                island.add(edge.joint);
                edge.joint.m_islandFlag = true;
                top = push(edge.other, top);
            }
        }
        return top;
    }

    private int push(Body body, int depth) {
        if ((body.m_flags & Body.e_islandFlag) != 0) {
            return depth;
        }
        body.m_flags |= Body.e_islandFlag;
        stack[depth] = body;
        return depth + 1;
    }
}
