package brickless.physics;

import static org.assertj.core.api.Assertions.assertThat;

import org.jbox2d.common.Sweep;
import org.junit.jupiter.api.Test;

/** Lengths are decimetres; half a hundredth is kept for rounding errors. */
class ClearanceTest {
    private final Clearance clearance = new Clearance();

    ClearanceTest() {
        clearance.setRadius(2);
        clearance.begin(at(1, 1, 3));
        clearance.limit(0.1f, 0.2f, 0.3f, 0.4f);
    }

    private static Sweep at(float x, float y, float angle) {
        Sweep sweep = new Sweep();
        sweep.c.set(x, y);
        sweep.a = angle;
        return sweep;
    }

    @Test
    void everySideHasItsOwnRoom() {
        assertThat(clearance.enough(at(0.91f, 1, 3))).isTrue();
        assertThat(clearance.enough(at(0.9f, 1, 3))).isFalse();
        assertThat(clearance.enough(at(1, 0.81f, 3))).isTrue();
        assertThat(clearance.enough(at(1, 0.8f, 3))).isFalse();
        assertThat(clearance.enough(at(1.29f, 1, 3))).isTrue();
        assertThat(clearance.enough(at(1.3f, 1, 3))).isFalse();
        assertThat(clearance.enough(at(1, 1.39f, 3))).isTrue();
        assertThat(clearance.enough(at(1, 1.4f, 3))).isFalse();
    }

    @Test
    void turningEitherWayTakesRoomFromAllSides() {
        assertThat(clearance.enough(at(1, 1, 3.047f))).isTrue();
        assertThat(clearance.enough(at(1, 1, 3.05f))).isFalse();
        assertThat(clearance.enough(at(1, 1, 2.95f))).isFalse();
        assertThat(clearance.enough(at(1.05f, 1, 2.95f))).as("away from the side that is short of room").isTrue();
    }

    @Test
    void goingBackGivesRoomBack() {
        assertThat(clearance.enough(at(1.5f, 1, 3))).isFalse();
        assertThat(clearance.enough(at(1, 1, 3))).isTrue();
    }

    @Test
    void theShapeWithTheLeastRoomCounts() {
        clearance.limit(0.5f, 0.5f, 0.05f, 0.5f);
        assertThat(clearance.enough(at(1.04f, 1, 3))).isTrue();
        assertThat(clearance.enough(at(1.05f, 1, 3))).isFalse();
        assertThat(clearance.enough(at(0.9f, 1, 3))).isFalse();
    }

    @Test
    void nothingIsKnownOfARobotThatWasMovedByHand() {
        clearance.forget();
        assertThat(clearance.enough(at(1, 1, 3))).isFalse();
        assertThat(clearance.radius()).isNegative();
    }
}
