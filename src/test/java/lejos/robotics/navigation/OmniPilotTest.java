package lejos.robotics.navigation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import lejos.hardware.Power;
import lejos.robotics.FakeMotor;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Three wheels of 48 mm, 100 mm from the middle, the central one in front. */
@Timeout(20)
@SuppressWarnings("deprecation")
class OmniPilotTest {
    private static final double DEGREES_PER_UNIT = 360 / (Math.PI * 48);

    private final FakeMotor central = new FakeMotor();
    private final FakeMotor clockwise = new FakeMotor();
    private final FakeMotor counterClockwise = new FakeMotor();
    private final OmniPilot pilot = new OmniPilot(100, 48, central, clockwise, counterClockwise, true, false,
            new EightVolts());
    private final Journal journal = new Journal();

    OmniPilotTest() {
        pilot.addMoveListener(journal);
        pilot.setLinearSpeed(100);
    }

    private static final class EightVolts implements Power {
        @Override
        public int getVoltageMilliVolt() {
            return 8000;
        }

        @Override
        public float getVoltage() {
            return 8;
        }

        @Override
        public float getBatteryCurrent() {
            return 0;
        }

        @Override
        public float getMotorCurrent() {
            return 0;
        }
    }

    @Test
    void forwardUsesTheTwoRearWheels() {
        pilot.travel(100);
        assertThat(central.getTachoCount()).isZero();
        assertThat(counterClockwise.getTachoCount()).isEqualTo((int) (Math.sqrt(3) / 2 * 100 * DEGREES_PER_UNIT));
        assertThat(clockwise.getTachoCount()).isEqualTo(-counterClockwise.getTachoCount());
        assertThat(journal.lines()).containsExactly("started TRAVEL 100 0", "stopped TRAVEL 100 0");
    }

    @Test
    void sidewaysUsesTheCentralWheelMost() {
        pilot.travel(100, 90.0);
        assertThat(central.getTachoCount()).isEqualTo((int) -(100 * DEGREES_PER_UNIT));
        assertThat(clockwise.getTachoCount()).isEqualTo(counterClockwise.getTachoCount()).isPositive();
    }

    @Test
    void turnsTurnAllWheelsAlike() {
        pilot.rotate(90);
        assertThat(central.getTachoCount()).isEqualTo(clockwise.getTachoCount())
                .isEqualTo(counterClockwise.getTachoCount()).isEqualTo((int) -(Math.PI / 2 * 100 * DEGREES_PER_UNIT));
        assertThat(journal.lines()).containsExactly("started ROTATE 0 90", "stopped ROTATE 0 90");
        assertThat(pilot.getAngularSpeed()).as("set because it was 0").isEqualTo(90);
    }

    @Test
    void arcsTurnWhileTheyDrive() {
        pilot.arc(200, 90);
        assertThat(journal.lines()).containsExactly("started ARC 314 90", "stopped ARC 314 90");
        pilot.travelArc(-200, -100);
        assertThat(journal.lines()).endsWith("started ARC -100 29", "stopped ARC -100 29");
    }

    @Test
    void drivesOnUntilStopped() {
        pilot.forward();
        assertThat(counterClockwise.lastCommand()).endsWith("forward");
        assertThat(clockwise.lastCommand()).endsWith("backward");
        pilot.stop();
        pilot.spinningMove(50, 30, 0);
        assertThat(pilot.isMoving()).isTrue();
        pilot.stop();
        assertThat(pilot.isMoving()).isFalse();
        assertThat(journal.lines()).hasSize(4);
    }

    @Test
    void limitsFollowTheBattery() {
        assertThat(pilot.getMaxLinearSpeed()).isCloseTo(Math.toRadians(800) * 24 * 2 / Math.sqrt(3), within(1e-9));
        assertThat(pilot.getMaxAngularSpeed()).isCloseTo(192, within(1e-9));
    }

    @Test
    void negativeSpeedTurnsForwardIntoBackward() {
        pilot.setLinearSpeed(-50);
        assertThat(pilot.getLinearSpeed()).isEqualTo(50);
        pilot.travel(100);
        assertThat(counterClockwise.getTachoCount()).isNegative();
        pilot.reset();
        assertThat(counterClockwise.getTachoCount()).isZero();
    }
}
