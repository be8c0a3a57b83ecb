package lejos.robotics.navigation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import lejos.Agreement;
import lejos.robotics.FakeMotor;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A car with wheels of 56 mm that steers to 50 degrees left and −60 right and then drives circles of 300 mm radius. */
@Timeout(20)
class SteeringPilotTest {
    private final FakeMotor drive = new FakeMotor();
    private final FakeMotor steering = new FakeMotor();
    private final SteeringPilot pilot = new SteeringPilot(56, drive, steering, 300, 50, -60);
    private final Journal journal = new Journal();

    SteeringPilotTest() {
        pilot.addMoveListener(journal);
    }

    @Test
    void carsAndOmnidirectionalRobotsAreCommandedAsByThePublishedPilots(@TempDir Path folder) {
        Agreement.checkInProcesses(OtherPilotsDriver.class, 60, 1.1e-3, folder);
    }

    @Test
    void arcIsDrivenWithTheLeastRadiusAndItsOwnLength() {
        pilot.arc(600, 90);
        assertThat(steering.getTachoCount()).isEqualTo(50);
        assertThat(drive.lastCommand()).as("942 mm").endsWith("rotate 1928");
        assertThat(journal.lines()).containsExactly("started ARC 942 180", "stopped ARC 942 180");
        pilot.travelArc(-300, -100);
        assertThat(steering.getTachoCount()).isEqualTo(-60);
        assertThat(journal.lines()).endsWith("stopped ARC -100 19");
    }

    @Test
    void straightLinesAreStraightWhateverTheSignOfInfinity() {
        pilot.travelArc(Double.NEGATIVE_INFINITY, 100);
        assertThat(steering.getTachoCount()).isZero();
        assertThat(journal.lines()).endsWith("stopped TRAVEL 100 0");
    }

    @Test
    void tooNarrowArcsAreRefused() {
        assertThatThrownBy(() -> pilot.arc(299, 10)).isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("300");
        assertThatThrownBy(() -> pilot.arc(0, 10)).isInstanceOf(IllegalArgumentException.class);
        assertThat(drive.commands()).isEmpty();
    }

    @Test
    void drivesOnUntilStopped() {
        pilot.arcBackward(300);
        assertThat(drive.lastCommand()).endsWith("backward");
        assertThat(pilot.getMovement().isMoving()).isTrue();
        pilot.stop();
        pilot.stop();
        assertThat(pilot.isMoving()).isFalse();
        assertThat(journal.lines()).hasSize(2);
    }

    @Test
    void speedsAreTheMotors() {
        pilot.setLinearSpeed(5);
        assertThat(pilot.getLinearSpeed() + pilot.getMaxLinearSpeed() + pilot.getLinearAcceleration()).isZero();
        assertThat(drive.getSpeed()).isZero();
    }
}
