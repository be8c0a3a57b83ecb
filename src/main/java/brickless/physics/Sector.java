package brickless.physics;

import java.util.Arrays;
import org.jbox2d.callbacks.TreeCallback;
import org.jbox2d.collision.AABB;
import org.jbox2d.collision.RayCastInput;
import org.jbox2d.collision.RayCastOutput;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Fixture;

/**
 * What rays that spread from one place can meet: looked up once for all of them. Own shapes of the robot that casts
 * them and low obstacles are left out. Finds what casting every ray at the whole arena finds, bit for bit (SectorTest).
 *
 * <p>There is one in an arena, used for one place after the other, so that it stays in the processor's cache.
 */
final class Sector {
    /** Added to the size of every box, metres: more than any rounding error. */
    private static final double SAFETY = 1e-4;

    private final LeanWorld world;
    private final TreeCallback gathering = this::gather;
    private final AABB box = new AABB();
    private final RayCastInput input = new RayCastInput();
    private final RayCastOutput output = new RayCastOutput();
    private final Vec2 normal = new Vec2();
    private Solid own;
    private double leastHeight;
    private double slender;
    private Aim aim;
    private double reach;
    private double cos;
    private double sin;
    private double edgeCos;
    private double edgeSin;

    private int shapes;
    private Fixture[] fixtures = new Fixture[16];
    /**
     * Where the boxes of the shapes are from here, in the direction of the sector and to the right of it, and their
     * radii; metres.
     */
    private double[] ahead = new double[16];
    private double[] aside = new double[16];
    private double[] radius = new double[16];
    private int thin;
    private ObstacleBody[] obstacles = new ObstacleBody[16];

    Sector(LeanWorld world) {
        this.world = world;
    }

    /** Chooses what is lower to be passed over, and the robot that looks and does not see itself; may be null. */
    void see(double leastHeightMetres, Solid self) {
        leastHeight = leastHeightMetres;
        own = self;
    }

    /**
     * Looks from a place.
     *
     * @param from where and in which direction
     * @param halfAngleCos cosine of the angle to either side, which is less than a right angle
     * @param halfAngleSin its sine
     * @param reachMetres length of the rays
     * @param slenderMetres obstacles with a smaller radius are listed if their middle may be at most that much farther
     *         away than the rays reach
     */
    void face(Aim from, double halfAngleCos, double halfAngleSin, double reachMetres, double slenderMetres) {
        aim = from;
        reach = reachMetres;
        slender = slenderMetres;
        edgeCos = halfAngleCos;
        edgeSin = halfAngleSin;
        cos = StrictMath.cos(from.headingRadians);
        sin = StrictMath.sin(from.headingRadians);
        shapes = 0;
        thin = 0;
        double length = (reachMetres + slenderMetres) / halfAngleCos;
        double leftX = length * (cos * halfAngleCos + sin * halfAngleSin);
        double leftY = length * (sin * halfAngleCos - cos * halfAngleSin);
        double rightX = length * (cos * halfAngleCos - sin * halfAngleSin);
        double rightY = length * (sin * halfAngleCos + cos * halfAngleSin);
        double margin = slenderMetres + SAFETY;
        box.lowerBound.set(Decimetres.of(from.x + Math.min(0, Math.min(leftX, rightX)) - margin),
                Decimetres.of(from.y + Math.min(0, Math.min(leftY, rightY)) - margin));
        box.upperBound.set(Decimetres.of(from.x + Math.max(0, Math.max(leftX, rightX)) + margin),
                Decimetres.of(from.y + Math.max(0, Math.max(leftY, rightY)) + margin));
        world.find(gathering, box);
    }

    private boolean gather(int proxy) {
        Fixture fixture = world.fixture(proxy);
        Solid solid = (Solid) fixture.m_body.m_userData;
        if (solid == own || fixture.m_isSensor) {
            return true;
        }
        if (solid instanceof ObstacleBody obstacle) {
            if (obstacle.radiusMetres() < slender) {
                list(obstacle);
            }
            if (obstacle.description().heightMetres() < leastHeight) {
                return true;
            }
        }
        add(fixture, world.fatBox(proxy));
        return true;
    }

    /** Notes an obstacle, each once though it may have many shapes. */
    private void list(ObstacleBody obstacle) {
        for (int i = thin - 1; i >= 0; i--) {
            if (obstacles[i] == obstacle) {
                return;
            }
        }
        if (thin == obstacles.length) {
            obstacles = Arrays.copyOf(obstacles, 2 * thin);
        }
        obstacles[thin++] = obstacle;
    }

    /** Notes a shape unless its box is beside or behind the sector. */
    private void add(Fixture fixture, AABB around) {
        double dx = Decimetres.metres(around.lowerBound.x + around.upperBound.x) / 2 - aim.x;
        double dy = Decimetres.metres(around.lowerBound.y + around.upperBound.y) / 2 - aim.y;
        double width = Decimetres.metres(around.upperBound.x - around.lowerBound.x);
        double height = Decimetres.metres(around.upperBound.y - around.lowerBound.y);
        double size = Math.sqrt(width * width + height * height) / 2 + SAFETY;
        double forward = dx * cos + dy * sin;
        double right = dy * cos - dx * sin;
        if (forward < -size || Math.abs(right) * edgeCos - forward * edgeSin > size) {
            return;
        }
        if (shapes == fixtures.length) {
            fixtures = Arrays.copyOf(fixtures, 2 * shapes);
            ahead = Arrays.copyOf(ahead, 2 * shapes);
            aside = Arrays.copyOf(aside, 2 * shapes);
            radius = Arrays.copyOf(radius, 2 * shapes);
        }
        fixtures[shapes] = fixture;
        ahead[shapes] = forward;
        aside[shapes] = right;
        radius[shapes++] = size;
    }

    /** Number of slender obstacles that may be within the sector. */
    int obstacles() {
        return thin;
    }

    ObstacleBody obstacle(int i) {
        return obstacles[i];
    }

    /**
     * Casts a ray.
     *
     * @param turnRadians direction against that of the sector
     * @param turnCos its cosine, no more than roughly right
     * @param turnSin its sine, likewise
     * @param out receives the nearest hit
     */
    void cast(double turnRadians, double turnCos, double turnSin, RayHit out) {
        boolean aimed = false;
        Fixture best = null;
        double rayCos = 0;
        double raySin = 0;
        double far = reach;
        for (int i = 0; i < shapes; i++) {
            if (Math.abs(aside[i] * turnCos - ahead[i] * turnSin) > radius[i]
                    || Math.abs(2 * (ahead[i] * turnCos + aside[i] * turnSin) - far) > far + 2 * radius[i]) {
                continue;
            }
            if (!aimed) {
                rayCos = StrictMath.cos(aim.headingRadians + turnRadians);
                raySin = StrictMath.sin(aim.headingRadians + turnRadians);
                direct(rayCos, raySin);
                aimed = true;
            }
            if (fixtures[i].raycast(output, input, 0)) {
                best = fixtures[i];
                input.maxFraction = output.fraction;
                far = output.fraction * reach;
                normal.set(output.normal);
            }
        }
        if (best == null) {
            out.clear();
        } else {
            out.set(input.maxFraction * reach, -(rayCos * normal.x + raySin * normal.y),
                    (Solid) best.m_body.m_userData);
        }
    }

    private void direct(double rayCos, double raySin) {
        input.p1.set(Decimetres.of(aim.x), Decimetres.of(aim.y));
        input.p2.set(Decimetres.of(aim.x + rayCos * reach), Decimetres.of(aim.y + raySin * reach));
        input.maxFraction = 1;
    }
}
