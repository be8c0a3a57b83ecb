package lejos.robotics.navigation;

import static org.assertj.core.api.Assertions.assertThat;

import lejos.Agreement;
import lejos.robotics.pathfinding.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Timeout(60)
class NavigatorTest {
    private final FakeController pilot = new FakeController(0);
    private final Navigator navigator = new Navigator(pilot);
    private final Journal journal = new Journal();

    NavigatorTest() {
        navigator.addNavigationListener(journal);
    }

    @Test
    void navigatorsLeadTheirPilotsAsThePublishedOne(@TempDir java.nio.file.Path folder) {
        Agreement.checkInProcesses(NavigatorDriver.class, 683, 2e-3, folder); // for 683 two ways are equally short
    }

    @Test
    void turnsAndDrivesToEachWaypoint() {
        navigator.addWaypoint(100, 0);
        navigator.addWaypoint(100, 50);
        navigator.followPath();
        assertThat(navigator.waitForStop()).isTrue();
        assertThat(pilot.calls()).containsExactly("rotate 0.0", "travel 100.0", "rotate 90.0", "travel 50.0");
        assertThat(journal.lines()).containsExactly("at 100.0 0.0, 1", "at 100.0 50.0, 2", "complete 2");
    }

    @Test
    void lastHeadingIsReachedByTheShorterTurn() {
        navigator.goTo(0, -10, 135);
        navigator.waitForStop();
        assertThat(pilot.calls()).endsWith("travel 10.0", "rotate -135.0");
    }

    @Test
    void singleStepsEndAtEachWaypoint() {
        navigator.addWaypoint(10, 0);
        navigator.addWaypoint(20, 0);
        navigator.singleStep(true);
        navigator.followPath();
        assertThat(navigator.waitForStop()).isFalse();
        assertThat(journal.lines()).containsExactly("at 10.0 0.0, 1");
        navigator.followPath();
        assertThat(navigator.waitForStop()).isTrue();
        assertThat(navigator.pathCompleted()).isTrue();
    }

    @Test
    void interruptedPathCanBeContinued() {
        pilot.setEndless();
        Path path = new Path();
        path.add(new Waypoint(30, 0));
        path.add(new Waypoint(60, 0));
        navigator.followPath(path);
        navigator.stop();
        assertThat(navigator.waitForStop()).isFalse();
        assertThat(navigator.isMoving()).isFalse();
        assertThat(journal.lines()).singleElement().asString().startsWith("interrupted");
        assertThat(pilot.calls()).contains("stop");
        navigator.followPath();
        assertThat(navigator.waitForStop()).isTrue();
        assertThat(path).as("reached waypoints leave the caller's path").isEmpty();
        assertThat(journal.lines()).endsWith("at 30.0 0.0, 1", "at 60.0 0.0, 2", "complete 2");
    }

    @Test
    void listenerThatAddsAWaypointKeepsTheRobotGoing() {
        journal.onStop(() -> navigator.addWaypoint(20, 0));
        navigator.goTo(10, 0);
        assertThat(navigator.waitForStop()).isTrue();
        assertThat(journal.lines()).containsExactly("at 10.0 0.0, 1", "at 20.0 0.0, 1", "complete 1");
    }

    @Test
    void stopOfARestingNavigatorIsTold() {
        navigator.stop();
        assertThat(journal.lines()).containsExactly("interrupted nowhere, 0");
    }

    @Test
    void rotateToTurnsTheShorterWay() {
        assertThat(navigator.rotateTo(270)).isTrue();
        assertThat(pilot.calls()).containsExactly("rotate -90.0");
    }

    @Test
    void arcsAreUsedByAPilotThatCannotTurnOnTheSpot() {
        FakeController car = new FakeController(20);
        Navigator driver = new Navigator(car);
        driver.goTo(100, -100);
        driver.waitForStop();
        assertThat(car.calls()).containsExactly("arc -20.0 16.6", "arc infinite 126.5");
        assertThat(driver.getPoseProvider().getPose().distanceTo(new Waypoint(100, -100))).isLessThan(0.1f);
    }

    @Test
    void noWayAlongArcsIsAnInterruption() {
        FakeController car = new FakeController(20);
        Navigator driver = new Navigator(car);
        driver.addNavigationListener(journal);
        driver.goTo(Float.NaN, 0);
        assertThat(driver.waitForStop()).as("the path is not complete").isFalse();
        while (journal.lines().isEmpty()) {
            Thread.onSpinWait(); // listeners hear of an interruption after the robot has stopped
        }
        assertThat(journal.lines()).singleElement().asString().startsWith("interrupted NaN");
        assertThat(car.calls()).containsExactly("stop");
        driver.clearPath();
        driver.goTo(100, -100);
        assertThat(driver.waitForStop()).as("it still works").isTrue();
    }

    @Test
    void clearedPathIsNotFollowed() {
        navigator.addWaypoint(10, 0);
        navigator.clearPath();
        navigator.followPath();
        assertThat(navigator.waitForStop()).isTrue();
        assertThat(navigator.getWaypoint()).isNull();
        assertThat(pilot.calls()).isEmpty();
    }
}
