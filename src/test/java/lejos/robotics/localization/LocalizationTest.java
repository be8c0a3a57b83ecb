package lejos.robotics.localization;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import lejos.Agreement;
import lejos.Bytes;
import lejos.robotics.DirectionFinder;
import lejos.robotics.RangeFinder;
import lejos.robotics.RangeReadings;
import lejos.robotics.RangeScanner;
import lejos.robotics.geometry.Line;
import lejos.robotics.geometry.Point;
import lejos.robotics.geometry.Rectangle;
import lejos.robotics.mapping.LineMap;
import lejos.robotics.navigation.Move.MoveType;
import lejos.robotics.navigation.Pose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class LocalizationTest {
    private final LineMap room = new LineMap(new Line[] {new Line(0, 0, 200, 0), new Line(200, 0, 200, 100),
        new Line(200, 100, 0, 100), new Line(0, 100, 0, 0)}, new Rectangle(0, 0, 200, 100));
    private final FakePilot pilot = new FakePilot();

    @BeforeEach
    void chooseTheSeed() {
        MCLParticle.RANDOM.setSeed(1);
        MCLParticleSet.RANDOM.setSeed(2);
    }

    @Test
    void providersAnswerAsThePublishedOnes() {
        Agreement.check(LocalizationDriver.class, 3000, 5e-4, LocalizationDriver::play);
    }

    @Test
    void squareEndsWhereItBegan() {
        OdometryPoseProvider odometry = new OdometryPoseProvider(pilot);
        for (int side = 0; side < 4; side++) {
            pilot.start();
            pilot.stop(MoveType.TRAVEL, 100, 0);
            pilot.start();
            pilot.stop(MoveType.ROTATE, 0, 90);
        }
        assertPose(odometry.getPose(), 0, 0, 0);
    }

    @Test
    void poseSetDuringAMoveIsWhereTheRestOfItBegins() {
        OdometryPoseProvider odometry = new OdometryPoseProvider(pilot);
        pilot.start();
        pilot.progress(MoveType.TRAVEL, 30, 0);
        odometry.setPose(new Pose(0, 0, 90));
        pilot.stop(MoveType.TRAVEL, 50, 0);
        assertPose(odometry.getPose(), 0, 20, 90);
    }

    @Test
    void backwardTravelMovesBack() {
        OdometryPoseProvider odometry = new OdometryPoseProvider(pilot);
        pilot.start();
        pilot.stop(MoveType.TRAVEL, -50, 0);
        assertPose(odometry.getPose(), -50, 0, 0);
    }

    @Test
    void compassReplacesTheHeadingOnlyInWhatIsDelivered() {
        CompassPoseProvider provider = new CompassPoseProvider(pilot, new NorthIs(77));
        pilot.start();
        pilot.stop(MoveType.ROTATE, 0, 90);
        pilot.start();
        pilot.stop(MoveType.TRAVEL, 40, 0);
        assertPose(provider.getPose(), 0, 40, 77);
    }

    private record NorthIs(float getDegreesCartesian) implements DirectionFinder {
        @Override
        public void resetCartesianZero() {
            throw new UnsupportedOperationException("a fixed compass");
        }

        @Override
        public void startCalibration() {
            throw new UnsupportedOperationException("a fixed compass");
        }

        @Override
        public void stopCalibration() {
            throw new UnsupportedOperationException("a fixed compass");
        }
    }

    @Test
    void aParticleWeighsTheProductOfItsErrors() {
        MCLParticle particle = new MCLParticle(new Pose(60, 30, 0));
        assertThat(particle.getWeight()).isEqualTo(1);
        RangeReadings readings = new RangeReadings(2);
        readings.setRange(0, 0, 140 + 10);
        readings.setRange(1, 90, 70 - 20);
        particle.calculateWeight(readings, room, 400);
        assertThat((double) particle.getWeight())
                .isCloseTo(Math.exp(-100 / 400.0) * Math.exp(-400 / 400.0), within(1e-5));
        particle = new MCLParticle(new Pose(-1, 30, 0));
        particle.calculateWeight(readings, room, 400);
        assertThat(particle.getWeight()).as("outside").isZero();
    }

    @Test
    void threeBearingsGiveThePose() {
        BeaconTriangle triangle = new BeaconTriangle(new Point(0, 0), new Point(100, 0), new Point(50, 100));
        Pose pose = triangle.calcPose(196.8699, 313.4349, 61.8699);
        assertThat(pose.getX()).isCloseTo(40, within(0.01f));
        assertThat(pose.getY()).isCloseTo(30, within(0.01f));
        assertThat(pose.getHeading()).isCloseTo(20, within(0.01f));
    }

    @Test
    void laterBearingsMayComeInAnotherOrder() {
        Point[] places = {new Point(0, 0), new Point(100, 0), new Point(50, 100)};
        List<Double> bearings = new ArrayList<>(List.of(196.8699, 313.4349, 61.8699));
        BeaconPoseProvider provider = new BeaconPoseProvider(() -> new ArrayList<>(bearings),
                new BeaconTriangle(places[0], places[1], places[2]), pilot, 1);
        assertPose(provider.getPose(), 40, 30, 20);
        for (int rotation = 0; rotation < 3; rotation++) {
            bearings.add(bearings.remove(0));
            pilot.start();
            pilot.stop(MoveType.STOP, 0, 0);
            assertPose(provider.getPose(), 40, 30, 20);
        }
    }

    @Test
    void particlesGatherWhereTheReadingsFit() {
        Pose truth = new Pose(60, 30, 0);
        MCLPoseProvider provider = new MCLPoseProvider(pilot, scannerAt(truth), room, 400, 5);
        provider.setInitialPose(truth, 20, 5);
        pilot.start();
        pilot.stop(MoveType.STOP, 0, 0);
        for (int i = 0; i < 5; i++) {
            provider.update();
        }
        Pose estimate = provider.getPose();
        assertThat(estimate.distanceTo(truth.getLocation())).isLessThan(15);
        assertThat(provider.getSigmaX()).isPositive().isLessThan(25);
        assertThat(Bytes.copy(provider, new MCLPoseProvider(room, 1, 0)).getEstimatedPose().getX())
                .isEqualTo(estimate.getX());
    }

    @Test
    void randomParticlesAreInsideTheMapAndItsBorder() {
        MCLParticleSet set = new MCLParticleSet(room, 500, 10);
        for (int i = 0; i < 500; i++) {
            Pose pose = set.getParticle(i).getPose();
            assertThat(pose.getX()).isBetween(10f, 190f);
            assertThat(pose.getY()).isBetween(10f, 90f);
            assertThat(pose.getHeading()).isBetween(0f, 360f);
        }
    }

    @Test
    void mapWithoutInsideIsRefused() {
        LineMap empty = new LineMap(new Line[0], new Rectangle(0, 0, 10, 10));
        assertThatThrownBy(() -> new MCLParticleSet(empty, 1, 0)).isInstanceOf(IllegalStateException.class);
    }

    @Test
    void resampleSpreadsAllOverTheMapIfNothingFits() {
        MCLParticleSet set = new MCLParticleSet(room, 10, new Pose(60, 30, 0), 1, 1);
        for (int i = 0; i < 10; i++) {
            set.getParticle(i).setWeight(-1);
        }
        assertThat(set.resample()).isTrue();
        assertThat(set.getParticle(0).getPose()).isNotSameAs(set.getParticle(1).getPose());
    }

    @Test
    void resampleNeverSharesAPose() {
        MCLParticleSet set = new MCLParticleSet(room, 10, new Pose(60, 30, 0), 1, 1);
        set.getParticle(0).setWeight(1);
        for (int i = 1; i < 10; i++) {
            set.getParticle(i).setWeight(0);
        }
        set.resample();
        assertThat(set.getParticle(0).getPose()).isNotSameAs(set.getParticle(9).getPose());
    }

    private RangeScanner scannerAt(Pose pose) {
        RangeReadings readings = new RangeReadings(3);
        for (int i = 0; i < 3; i++) {
            float angle = i * 90 - 90;
            readings.setRange(i, angle, room.range(new Pose(pose.getX(), pose.getY(), pose.getHeading() + angle)));
        }
        return new RangeScanner() {
            @Override
            public RangeReadings getRangeValues() {
                return readings;
            }

            @Override
            public void setAngles(float[] angles) {
                throw new UnsupportedOperationException("the angles of this scanner are fixed");
            }

            @Override
            public RangeFinder getRangeFinder() {
                throw new UnsupportedOperationException("this scanner has no range finder");
            }
        };
    }

    private static void assertPose(Pose pose, float x, float y, float heading) {
        assertThat(pose.getX()).isCloseTo(x, within(0.01f));
        assertThat(pose.getY()).isCloseTo(y, within(0.01f));
        assertThat(pose.getHeading()).isCloseTo(heading, within(0.01f));
    }
}
