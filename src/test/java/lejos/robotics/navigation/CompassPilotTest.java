package lejos.robotics.navigation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import lejos.robotics.DirectionFinder;
import lejos.robotics.FakeMotor;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Two wheels of 5.6 cm, 12 cm apart; the compass says what the wheels say, give or take an error. */
@Timeout(20)
@SuppressWarnings("deprecation")
class CompassPilotTest {
    private final FakeMotor left = new FakeMotor();
    private final FakeMotor right = new FakeMotor();
    private volatile float error;
    private final CompassPilot pilot = new CompassPilot(new WheelCompass(), 5.6f, 12, left, right);

    private final class WheelCompass implements DirectionFinder {
        @Override
        public float getDegreesCartesian() {
            float heading = (right.getTachoCount() - left.getTachoCount()) / 2f / (12 / 5.6f) + error;
            return (heading % 360 + 360) % 360;
        }

        @Override
        public void startCalibration() {}

        @Override
        public void stopCalibration() {}

        @Override
        public void resetCartesianZero() {}
    }

    @Test
    void typeOfTheNumberDecidesWhoTurns() {
        pilot.rotate(90.0);
        assertThat(pilot.getHeadingError()).as("turned without the compass").isCloseTo(90, within(1f));
        pilot.rotate(90f);
        assertThat(pilot.getCompassHeading()).as("the heading to keep was 0, and is 90 now")
                .isCloseTo(90, within(2.5f));
    }

    @Test
    void turnIsCorrectedUntilTheCompassAgrees() {
        error = -30;
        pilot.rotate(90f);
        assertThat(pilot.getCompassHeading()).as("within the accepted error of the estimate").isCloseTo(90, within(6f));
    }

    @Test
    void wrongHeadingIsSteeredAgainst() {
        pilot.setHeading(-20);
        pilot.travel(1000f, true);
        assertThat(pilot.isTraveling()).isTrue();
        while (!left.lastCommand().endsWith("forward")) {
            Thread.onSpinWait();
        }
        assertThat(left.getSpeed()).as("turns right").isGreaterThan(right.getSpeed());
        pilot.stop();
        assertThat(pilot.isTraveling()).isFalse();
        assertThat(pilot.isMoving()).isFalse();
    }

    @Test
    void shortWaysAreDrivenByTheWheelsAlone() {
        pilot.travel(2f);
        assertThat(pilot.getMovementIncrement()).isCloseTo(2, within(0.05f));
        assertThat(pilot.getAngleIncrement()).isZero();
    }

    @Test
    void nobodyBalancesOnABall() {
        assertThatThrownBy(() -> new Ballbot(null, null, null, null, 4))
                .isInstanceOf(UnsupportedOperationException.class);
    }
}
