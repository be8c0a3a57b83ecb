package lejos.robotics.navigation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import lejos.Agreement;
import lejos.robotics.FakeMotor;
import lejos.robotics.localization.OdometryPoseProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Two wheels of 56 mm, 120 mm apart, in millimetres; the motors' highest speed is 900 degrees per second. */
@Timeout(60)
@SuppressWarnings("deprecation")
class DifferentialPilotTest {
    private final FakeMotor left = new FakeMotor();
    private final FakeMotor right = new FakeMotor();
    private final DifferentialPilot pilot = new DifferentialPilot(56, 120, left, right);
    private final Journal journal = new Journal();

    DifferentialPilotTest() {
        pilot.addMoveListener(journal);
    }

    @Test
    void pilotsCommandTheirMotorsAsThePublishedOnes(@TempDir Path folder) {
        Agreement.checkInProcesses(PilotDriver.class, 2000, 2e-4, folder);
    }

    @Test
    void defaults() {
        assertThat(pilot.getLinearSpeed()).isCloseTo(351.86, within(0.01));
        assertThat(pilot.getAngularSpeed()).isCloseTo(336, within(1e-4));
        assertThat(pilot.getLinearAcceleration()).isCloseTo(1407.4, within(0.1));
        assertThat(pilot.getTurnRate()).isEqualTo(pilot.getAngularSpeed());
        assertThat(pilot.getAngularAcceleration()).isZero();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "100 | 90 | 180, rotate 128 | 720, rotate 514",
        "-100 | 90 | 720, rotate -514 | 180, rotate -128",
        "20 | 90 | 360, rotate -128 | 720, rotate 257",
        "0 | 90 | 720, rotate -192 | 720, rotate 192"})
    void angleOfAnArcIsTheChangeOfHeading(double radius, double angle, String leftMotion, String rightMotion) {
        pilot.arc(radius, angle);
        assertThat(left.lastCommand()).endsWith(leftMotion);
        assertThat(right.lastCommand()).endsWith(rightMotion);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "0 | 720, forward | 720, forward",
        "25 | 540, forward | 720, forward",
        "100 | stop | 720, forward",
        "200 | 720, backward | 720, forward",
        "-50 | 720, forward | 360, forward"})
    void steeringRateSlowsTheInnerWheel(double rate, String leftMotion, String rightMotion) {
        pilot.steer(rate);
        assertThat(left.lastCommand()).endsWith(leftMotion);
        assertThat(right.lastCommand()).endsWith(rightMotion);
    }

    @Test
    void steeringAnewDoesNotStopTheRobot() {
        pilot.steer(20);
        pilot.steer(-20);
        pilot.steerBackward(10);
        pilot.steer(0);
        assertThat(left.commands()).hasSize(4).noneMatch(command -> command.endsWith("stop"));
        pilot.stop();
        assertThat(journal.lines()).as("each curve is a move of its own").hasSize(8);
    }

    @Test
    void odometryLosesNothingBetweenCurves() {
        OdometryPoseProvider odometry = new OdometryPoseProvider(pilot);
        for (int i = 1; i <= 10; i++) {
            pilot.steer(i % 2 == 0 ? 30 : -30);
            left.setTacho(i * 100);
            right.setTacho(i * 100);
        }
        pilot.stop();
        assertThat(odometry.getPose().getX()).isCloseTo(488.7f, within(0.1f));
        assertThat(odometry.getPose().getY()).isCloseTo(0, within(0.1f));
    }

    @Test
    void backwardIsANegativeDistance() {
        pilot.travel(-50);
        assertThat(journal.lines()).containsExactly("started TRAVEL -50 0", "stopped TRAVEL -50 0");
        assertThat(pilot.getMovementIncrement()).isCloseTo(-49.85f, within(0.01f));
    }

    @Test
    void rotateRightIsAMoveToo() {
        pilot.rotateRight();
        assertThat(left.lastCommand()).endsWith("forward");
        assertThat(right.lastCommand()).endsWith("backward");
        pilot.stop();
        assertThat(journal.lines()).hasSize(2);
    }

    @Test
    void speedOfAMoveInProgressChangesAtOnce() {
        pilot.forward();
        pilot.setLinearSpeed(pilot.getLinearSpeed() / 2);
        assertThat(left.getSpeed()).isEqualTo(360);
        assertThat(left.commands()).hasSize(1);
    }

    @Test
    void quickStopLeavesTheAccelerationAsItWas() {
        pilot.forward();
        pilot.quickStop();
        assertThat(left.lastCommand()).startsWith("20460,");
        pilot.travel(10);
        assertThat(left.lastCommand()).startsWith("2880,");
    }

    @Test
    void accelerationInMetresIsNotLost() {
        new DifferentialPilot(0.056, 0.12, left, right).setLinearAcceleration(0.5);
        pilot.setLinearAcceleration(0.5);
        assertThat(pilot.getLinearAcceleration()).isEqualTo(0.5);
    }

    @Test
    void unequalWheelsDriveTheSameCurve() {
        DifferentialPilot limping = new DifferentialPilot(56, 28, 120, left, right, false);
        limping.arc(100, 90);
        assertThat(left.lastCommand()).endsWith("rotate 128");
        assertThat(right.lastCommand()).as("half the wheel, twice the turns").endsWith("rotate 1028");
    }

    @Test
    void listenerThatStopsAtTheStartPreventsTheMove() {
        journal.onStart(pilot::stop);
        pilot.forward();
        assertThat(left.commands()).containsOnlyOnce(left.lastCommand());
        assertThat(left.lastCommand()).endsWith("stop");
    }

    @Test
    void arcsOfRadiusZeroHaveNoDistance() {
        assertThatThrownBy(() -> pilot.travelArc(0, 5)).isInstanceOf(IllegalArgumentException.class);
        pilot.steer(50, 0);
        assertThat(left.commands()).isEmpty();
        pilot.arcForward(Double.POSITIVE_INFINITY);
        assertThat(left.lastCommand()).endsWith("720, forward");
    }
}
