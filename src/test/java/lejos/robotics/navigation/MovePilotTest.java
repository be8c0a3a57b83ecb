package lejos.robotics.navigation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import lejos.robotics.FakeMotor;
import lejos.robotics.chassis.Wheel;
import lejos.robotics.chassis.WheeledChassis;
import lejos.robotics.localization.OdometryPoseProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Two wheels of 56 mm, 120 mm apart, in millimetres. */
@Timeout(20)
class MovePilotTest {
    private final FakeMotor left = new FakeMotor();
    private final FakeMotor right = new FakeMotor();
    private final WheeledChassis chassis =
            new WheeledChassis(new Wheel[] {WheeledChassis.modelWheel(left, 56).offset(60),
        WheeledChassis.modelWheel(right, 56).offset(-60)}, WheeledChassis.TYPE_DIFFERENTIAL);
    private final MovePilot pilot = new MovePilot(chassis);
    private final Journal journal = new Journal();

    MovePilotTest() {
        pilot.addMoveListener(journal);
    }

    @Test
    void defaultSpeedsAreFourFifthsOfTheGreatest() {
        assertThat(pilot.getLinearSpeed()).isCloseTo(351.86, within(0.01));
        assertThat(pilot.getAngularSpeed()).isCloseTo(336, within(1e-9));
        assertThat(pilot.getLinearAcceleration()).isCloseTo(1407.43, within(0.01));
        assertThat(pilot.getAngularAcceleration()).isCloseTo(1344, within(1e-9));
    }

    @Test
    void listenersKnowOfAMoveWhenTheCallReturns() {
        pilot.travel(100);
        pilot.rotate(-90);
        assertThat(journal.lines()).containsExactly("started TRAVEL 100 0", "stopped TRAVEL 100 0",
                "started ROTATE 0 -90", "stopped ROTATE 0 -90");
        assertThat(journal.moves()).doesNotHaveDuplicates();
        assertThat(journal.moves()).extracting(Move::isMoving).containsOnly(false);
    }

    @Test
    void backwardTravelBringsTheRobotBack() {
        OdometryPoseProvider odometry = new OdometryPoseProvider(pilot);
        pilot.travel(50);
        pilot.travel(-50);
        assertThat(odometry.getPose().getX()).isCloseTo(0, within(1e-3f));
        pilot.travel(-100);
        assertThat(odometry.getPose().getX()).isCloseTo(-100, within(0.5f));
    }

    @Test
    void travelArcDrivesItsDistance() {
        pilot.travelArc(100, 157.08);
        assertThat(journal.lines()).containsExactly("started ARC 157 90", "stopped ARC 157 90");
        pilot.travelArc(Double.POSITIVE_INFINITY, 10);
        assertThat(journal.lines()).endsWith("started TRAVEL 10 0", "stopped TRAVEL 10 0");
        assertThatThrownBy(() -> pilot.travelArc(0, 10)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void arcToTheRightForwardHasANegativeRadiusAndAPositiveAngle() {
        pilot.arc(-200, 90);
        assertThat(left.commands()).singleElement().asString().endsWith("rotate 835");
        assertThat(journal.lines()).as("the plan keeps the sign of radius times angle")
                .containsExactly("started ARC -314 90", "stopped ARC 314 -90");
    }

    @Test
    void rotateLeftTurnsOnTheSpot() {
        pilot.rotateLeft();
        assertThat(left.lastCommand()).endsWith("backward");
        assertThat(right.lastCommand()).endsWith("forward");
        pilot.rotateRight();
        assertThat(left.lastCommand()).endsWith("forward");
        pilot.stop();
        assertThat(journal.lines()).hasSize(4);
    }

    @Test
    void eachMoveEndsBeforeTheNextBegins() {
        pilot.forward();
        pilot.backward();
        pilot.stop();
        assertThat(journal.lines()).extracting(line -> line.split(" ")[0])
                .containsExactly("started", "stopped", "started", "stopped");
    }

    @Test
    void stopOfARestingRobotReturns() {
        pilot.stop();
        assertThat(journal.lines()).isEmpty();
        assertThat(pilot.getMovement().getMoveType()).isEqualTo(Move.MoveType.STOP);
    }

    @Test
    void movementSaysHowFarTheMoveHasCome() {
        pilot.forward();
        left.setTacho(205);
        right.setTacho(205);
        assertThat(pilot.getMovement().getDistanceTraveled()).isCloseTo(100.2f, within(0.1f));
        pilot.stop();
        assertThat(journal.moves().get(1).getDistanceTraveled()).isCloseTo(100.2f, within(0.1f));
    }

    @Test
    void listenerOfAStopMayStopThePilot() {
        journal.onStop(pilot::stop);
        pilot.travel(10);
        assertThat(journal.lines()).containsExactly("started TRAVEL 10 0", "stopped TRAVEL 10 0");
    }

    @Test
    void listenerOfAStopMayDriveOnAndTheOthersHearInOrder() {
        Journal other = new Journal();
        pilot.addMoveListener(other);
        journal.onStop(() -> pilot.rotate(90));
        pilot.travel(10);
        assertThat(journal.lines()).containsExactly("started TRAVEL 10 0", "stopped TRAVEL 10 0", "started ROTATE 0 90",
                "stopped ROTATE 0 90");
        assertThat(other.lines()).isEqualTo(journal.lines());
    }

    @Test
    void listenerOfAStartMayStopThePilot() {
        journal.onStart(pilot::stop);
        pilot.forward();
        assertThat(left.lastCommand()).endsWith("stop");
        assertThat(journal.lines()).containsExactly("started TRAVEL Infinity 0", "stopped STOP 0 0");
    }

    @Test
    void stallEndsTheMove() {
        left.setSlow();
        right.setSlow();
        pilot.travel(1000, true);
        left.stall();
        pilot.getMovement();
        waitForRest();
        assertThat(right.lastCommand()).as("the other wheel is stopped, too").endsWith("stop");
        pilot.travel(10, true);
        left.finish();
        right.finish();
        pilot.stop();
        assertThat(journal.lines()).filteredOn(line -> line.startsWith("stopped")).hasSize(2);
    }

    private void waitForRest() {
        CountDownLatch stopped = new CountDownLatch(1);
        journal.onStop(stopped::countDown);
        try {
            if (journal.lines().size() < 2) {
                assertThat(stopped.await(10, TimeUnit.SECONDS)).isTrue();
            }
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    @Test
    void blockedThreadReturnsWhenAnotherStops() throws InterruptedException {
        left.setSlow();
        right.setSlow();
        CountDownLatch begun = new CountDownLatch(1);
        journal.onStart(begun::countDown);
        Thread driver = new Thread(() -> pilot.travel(1000));
        driver.start();
        begun.await();
        pilot.stop();
        driver.join();
        assertThat(journal.lines()).hasSize(2);
    }

    @Test
    void refusedSpeedChangesNothing() {
        double before = pilot.getLinearSpeed();
        assertThatThrownBy(() -> pilot.setLinearSpeed(0)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> pilot.setAngularAcceleration(-1)).isInstanceOf(IllegalArgumentException.class);
        assertThat(pilot.getLinearSpeed()).isEqualTo(before);
    }

    @Test
    void arcBelowTheLeastRadiusIsRefused() {
        pilot.setMinRadius(50);
        assertThatThrownBy(() -> pilot.arc(-40, 10)).isInstanceOf(RuntimeException.class);
        assertThatThrownBy(() -> pilot.rotate(10)).isInstanceOf(RuntimeException.class);
        assertThat(left.commands()).isEmpty();
    }

    @Test
    @SuppressWarnings("deprecation")
    void deprecatedConstructorsPutTheLeftWheelToTheLeft() {
        new MovePilot(56, 120, left, right).rotate(90);
        assertThat(left.lastCommand()).endsWith("rotate -192");
        new MovePilot(56, 56, 120, left, right, true).travel(100);
        assertThat(left.lastCommand()).endsWith("rotate -204");
    }

    @Test
    @SuppressWarnings("deprecation")
    void namesBefore091DoWhatTheNewOnesDo() {
        pilot.setTravelSpeed(100);
        pilot.setRotateSpeed(90);
        assertThat(pilot.getLinearSpeed()).isEqualTo(100).isEqualTo(pilot.getTravelSpeed());
        assertThat(pilot.getAngularSpeed()).isEqualTo(90).isEqualTo(pilot.getRotateSpeed());
        assertThat(pilot.getMaxTravelSpeed()).isEqualTo(pilot.getMaxLinearSpeed());
        assertThat(pilot.getRotateMaxSpeed()).isEqualTo(pilot.getMaxAngularSpeed());
        assertThat((double) pilot.getMaxRotateSpeed()).isCloseTo(420, within(1e-3));
    }
}
