package brickless.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import brickless.TestWorlds;
import brickless.world.Obstacle;
import brickless.world.Point2;
import brickless.world.Pose2;
import brickless.world.Rgb;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.junit.jupiter.api.Test;

/** What is looked up once for a fan of rays is all that its rays can meet. */
class SectorTest {
    private static final int PLACES = 3_000;
    private static final int RAYS = 7;
    private static final double LOW = 0.05;

    private final Random random = new Random(1);
    private final LeanWorld world = new LeanWorld();
    private final List<ObstacleBody> obstacles = new ArrayList<>();
    private final List<RobotBody> robots = new ArrayList<>();
    private final Sector sector = new Sector(world);
    private final RayHit hit = new RayHit();
    private final Aim aim = new Aim();

    /** Four by four metres with forty low and high boxes of 1 to 40 cm, some at odd angles, and three robots. */
    SectorTest() {
        Decimetres.use();
        Body ground = world.createBody(new BodyDef());
        for (int i = 0; i < 40; i++) {
            Obstacle box = TestWorlds.crate("box" + i, even(-2, 2), even(-2, 2), even(0.01, 0.4), 1);
            obstacles.add(new ObstacleBody(world, ground,
                    new Obstacle(box.id(), box.outlines(), i % 2 == 0, 1, i % 3 == 0 ? 0.03 : 0.1, 0.5, false,
                    box.colour())));
            if (i % 4 == 0) {
                obstacles.get(i).place(new Pose2(even(-2, 2), even(-2, 2), even(-4, 4)));
            }
        }
        for (int i = 0; i < 3; i++) {
            Entrant entrant = new Entrant("robot" + i, TestWorlds.educator(),
                    new Pose2(even(-1, 1), even(-1, 1), even(-4, 4)));
            robots.add(new RobotBody(world, ground, entrant, i, false, obstacles.size()));
        }
        world.step(0.002f, 6, 2);
    }

    private double even(double from, double to) {
        return from + random.nextDouble() * (to - from);
    }

    private void aimAnywhere() {
        aim.x = even(-2.2, 2.2);
        aim.y = even(-2.2, 2.2);
        aim.headingRadians = even(-20, 20);
    }

    @Test
    void everyRayMeetsWhatJBox2DMeets() {
        int met = 0;
        for (int place = 0; place < PLACES; place++) {
            aimAnywhere();
            double half = place % 5 == 0 ? 0 : even(0, 1.4);
            double reach = even(0.1, 3);
            RobotBody own = place % 2 == 0 ? robots.get(place % 3) : null;
            sector.see(LOW, own);
            sector.face(aim, StrictMath.cos(half), StrictMath.sin(half), reach, even(0, 0.2));
            for (int ray = 0; ray < RAYS; ray++) {
                double turn = half * (ray - RAYS / 2) / (RAYS / 2);
                sector.cast(turn, StrictMath.cos(turn), StrictMath.sin(turn), hit);
                assertThat(hit.distanceMetres()).as("place %d ray %d", place, ray).isEqualTo(nearest(turn, reach, own));
                met += hit.solid() == null ? 0 : 1;
            }
        }
        assertThat(met).as("rays that met something").isBetween(PLACES * RAYS / 4, PLACES * RAYS * 3 / 4);
    }

    /** Distance of what JBox2D's own ray meets first. */
    private double nearest(double turn, double reach, RobotBody own) {
        float[] best = {Float.POSITIVE_INFINITY};
        double heading = aim.headingRadians + turn;
        Vec2 from = new Vec2(Decimetres.of(aim.x), Decimetres.of(aim.y));
        Vec2 to = new Vec2(Decimetres.of(aim.x + StrictMath.cos(heading) * reach),
                Decimetres.of(aim.y + StrictMath.sin(heading) * reach));
        world.raycast((fixture, point, normal, fraction) -> {
            Object solid = fixture.getBody().getUserData();
            if (solid == own || solid instanceof ObstacleBody obstacle && obstacle.description().heightMetres() < LOW) {
                return -1;
            }
            best[0] = fraction;
            return fraction;
        }, from, to);
        return best[0] * reach;
    }

    @Test
    void everySlenderObstacleWhoseMiddleMayBeInTheSectorIsListedOnce() {
        for (int place = 0; place < PLACES; place++) {
            aimAnywhere();
            double half = even(0, 0.5);
            double reach = even(0.1, 3);
            double slender = even(0, 0.2);
            sector.see(0, null);
            sector.face(aim, StrictMath.cos(half), StrictMath.sin(half), reach, slender);
            List<ObstacleBody> listed = new ArrayList<>();
            for (int i = 0; i < sector.obstacles(); i++) {
                listed.add(sector.obstacle(i));
            }
            assertThat(listed).as("place %d", place).doesNotHaveDuplicates()
                    .allMatch(obstacle -> obstacle.radiusMetres() < slender);
            assertThat(listed).as("place %d", place)
                    .containsAll(obstacles.stream().filter(obstacle -> obstacle.radiusMetres() < slender)
                    .filter(obstacle -> inSector(obstacle, half, reach)).toList());
        }
    }

    private boolean inSector(ObstacleBody obstacle, double half, double reach) {
        double dx = obstacle.centreX() - aim.x;
        double dy = obstacle.centreY() - aim.y;
        double bearing = StrictMath.IEEEremainder(StrictMath.atan2(dy, dx) - aim.headingRadians, 2 * StrictMath.PI);
        return Math.abs(bearing) <= half && StrictMath.hypot(dx, dy) <= reach + obstacle.radiusMetres();
    }

    @Test
    void anObstacleOfManyShapesIsListedOnce() {
        List<Point2> star = new ArrayList<>();
        for (int i = 0; i < 14; i++) {
            double radius = i % 2 == 0 ? 0.05 : 0.02;
            star.add(new Point2(5 + radius * StrictMath.cos(i * StrictMath.PI / 7),
                    radius * StrictMath.sin(i * StrictMath.PI / 7)));
        }
        Body ground = world.createBody(new BodyDef());
        ObstacleBody post = new ObstacleBody(world, ground,
                new Obstacle("post", List.of(star), false, 0, 0.1, 0.5, false, new Rgb(0, 0, 0)));
        aim.x = 4.5;
        sector.see(0, null);
        sector.face(aim, 1, 0, 1, 0.1);
        assertThat(sector.obstacles()).isEqualTo(1);
        assertThat(sector.obstacle(0)).isSameAs(post);
        sector.cast(0, 1, 0, hit);
        assertThat(hit.solid()).isSameAs(post);
        assertThat(hit.distanceMetres()).as("the dent between two points of the star").isCloseTo(0.48, within(1e-6));
    }
}
