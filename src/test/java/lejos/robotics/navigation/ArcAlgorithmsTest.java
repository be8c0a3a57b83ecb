package lejos.robotics.navigation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import lejos.Agreement;
import lejos.robotics.geometry.Point;
import org.junit.jupiter.api.Test;

class ArcAlgorithmsTest {
    private static final float RADIUS = 20;

    @Test
    void waysAreThePublishedOnes() {
        Agreement.check(ArcDriver.class, 3000, 1e-2, ArcDriver::play);
    }

    @Test
    void shortestWayToAPointBehindTheRightShoulder() {
        Move[] way = ArcAlgorithms.getBestPath(new Pose(0, 0, 0), new Point(100, -100), RADIUS);
        assertThat(way).hasSize(2);
        assertThat(way[0].getDistanceTraveled()).isCloseTo(16.63f, within(0.01f));
        assertThat(way[0].getAngleTurned()).isCloseTo(-47.64f, within(0.01f));
        assertThat(way[0].getArcRadius()).isEqualTo(-RADIUS);
        assertThat(way[1].getDistanceTraveled()).isCloseTo(126.49f, within(0.01f));
        assertThat(way[1].getArcRadius()).isInfinite();
    }

    @Test
    void everyWayToAPoseLeadsThere() {
        Pose end = new Pose(100, 50, 90);
        for (float last : new float[] {RADIUS, -RADIUS, 35, -35}) {
            Move[][] ways = ArcAlgorithms.getAvailablePaths(new Pose(0, 0, 0), RADIUS, end, last);
            for (Move[] way : ways) {
                Pose pose = new Pose(0, 0, 0);
                for (Move move : way) {
                    pose.arcUpdate(move.getDistanceTraveled(), move.getAngleTurned());
                }
                assertThat(pose.distanceTo(end.getLocation())).isLessThan(0.05f);
                assertThat(pose.getHeading()).isCloseTo(90, within(0.05f));
            }
        }
    }

    @Test
    void noWayIsNull() {
        Move nowhere = new Move(Move.MoveType.ARC, Float.NaN, Float.NaN, false);
        assertThat(ArcAlgorithms.getBestPath(new Move[][] {{nowhere}, {nowhere}})).isNull();
    }

    @Test
    void arcBackwardIsTheRestOfTheCircle() {
        assertThat(ArcAlgorithms.getArcBackward(90)).isEqualTo(-270);
        assertThat(ArcAlgorithms.getArcBackward(-90)).isEqualTo(270);
        assertThat(ArcAlgorithms.getArcBackward(0)).isZero();
    }
}
