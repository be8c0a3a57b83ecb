package lejos.robotics.navigation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import lejos.Agreement;
import lejos.robotics.geometry.Point;
import org.junit.jupiter.api.Test;

class MoveTest {
    @Test
    void posesMovesAndWaypointsAnswerAsThePublishedOnes() {
        Agreement.check(MoveDriver.class, 3000, 2e-4, MoveDriver::play);
    }

    @Test
    void quarterArcToTheLeftEndsAheadAndLeft() {
        Pose pose = new Pose();
        pose.arcUpdate((float) (Math.PI * 50), 90);
        assertThat(pose.getX()).isCloseTo(100, within(1e-3f));
        assertThat(pose.getY()).isCloseTo(100, within(1e-3f));
        assertThat(pose.getHeading()).isEqualTo(90);
    }

    @Test
    void headingIsWrappedToAHalfTurnEachWay() {
        Pose pose = new Pose(0, 0, 170);
        pose.rotateUpdate(10);
        assertThat(pose.getHeading()).isEqualTo(180);
        pose.rotateUpdate(1);
        assertThat(pose.getHeading()).isEqualTo(-179);
        assertThat(new Pose(0, 0, 180).relativeBearing(new Point(-10, 0))).isZero();
    }

    @Test
    void texts() {
        assertThat(new Pose(1.4f, 2.5f, -3)).hasToString("X:1 Y:3 H:-3");
        assertThat(new Move(Move.MoveType.TRAVEL, 10, 0, 5, 0, true)).hasToString("TRAVEL 10.0 at 5.0");
        assertThat(new Move(Move.MoveType.ROTATE, 0, 90, 5, 30, true)).hasToString("ROTATE 90.0 at 30.0");
        Move arc = new Move(true, 90, 20);
        arc.setDynamics(5, 30);
        assertThat(arc).hasToString("ARC  of 20.0 for 90.0degrees  at 5.0");
        assertThat(new Move(0, 0, false)).hasToString("STOP ");
        assertThat(new Waypoint(1, 2)).hasToString("Point2D.Float[1.0, 2.0]");
    }

    @Test
    void kindFollowsFromWhatIsZero() {
        assertThat(new Move(0, 0, true).getMoveType()).isEqualTo(Move.MoveType.STOP);
        assertThat(new Move(1, 0, true).getMoveType()).isEqualTo(Move.MoveType.TRAVEL);
        assertThat(new Move(0, 1, true).getMoveType()).isEqualTo(Move.MoveType.ROTATE);
        assertThat(new Move(1, 1, true).getMoveType()).isEqualTo(Move.MoveType.ARC);
    }
}
