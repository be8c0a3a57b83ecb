package lejos.robotics.objectdetection;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.atomic.AtomicInteger;
import lejos.Bytes;
import lejos.robotics.RangeFinder;
import lejos.robotics.RangeReading;
import lejos.robotics.RangeReadings;
import lejos.robotics.localization.PoseProvider;
import lejos.robotics.navigation.Pose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(10)
class DetectorTest {
    private final BlockingQueue<Feature> found = new ArrayBlockingQueue<>(1000);

    @Test
    void objectCountsIfStrictlyNearerThanTheDistance() {
        assertThat(new RangeFeatureDetector(ranges(0.49f), 0.5f, 100).scan()).isNotNull();
        assertThat(new RangeFeatureDetector(ranges(0.5f), 0.5f, 100).scan()).isNull();
        assertThat(new RangeFeatureDetector(ranges(0), 0.5f, 100).scan()).isNull();
        assertThat(new RangeFeatureDetector(ranges(), 0.5f, 100).scan()).isNull();
        assertThat(new RangeFeatureDetector(ranges(Float.NaN), 0.5f, 100).scan()).isNull();
    }

    @Test
    void allRangesAreReportedAtTheSensorsAngle() {
        RangeReadings readings = new RangeFeatureDetector(ranges(0.1f, 9), 0.5f, 100, 30).scan().getRangeReadings();
        assertThat(readings).hasSize(2);
        assertThat(readings.getRange(1)).isEqualTo(9);
        assertThat(readings.getAngle(1)).isEqualTo(30);
    }

    @Test
    void featureCarriesThePoseIfKnown() {
        RangeFeatureDetector detector = new RangeFeatureDetector(ranges(0.1f), 0.5f, 100);
        detector.setPoseProvider(new PoseProvider() {
            @Override
            public Pose getPose() {
                return new Pose(1, 2, 3);
            }

            @Override
            public void setPose(Pose aPose) {
                throw new UnsupportedOperationException("this robot is fixed");
            }
        });
        assertThat(((RangeFeature) detector.scan()).getPose().getY()).isEqualTo(2);
    }

    @Test
    void bumperIsWhereItWasSaidToBe() {
        RangeReading right = new TouchFeatureDetector(() -> true, 5, 0).scan().getRangeReading();
        assertThat(right.getAngle()).isEqualTo(-90);
        assertThat(right.getRange()).isEqualTo(5);
        RangeReading front = new TouchFeatureDetector(() -> true, 0, 12).scan().getRangeReading();
        assertThat(front.getAngle()).isCloseTo(0, within(1e-5f));
        assertThat(new TouchFeatureDetector(() -> false).scan()).isNull();
    }

    @Test
    void listenersAreToldAgainAndAgain() throws InterruptedException {
        FeatureDetector detector = new RangeFeatureDetector(ranges(0.1f), 0.5f, 1);
        detector.addListener((feature, source) -> found.offer(source == detector ? feature : null));
        assertThat(found.take()).isNotSameAs(found.take());
        detector.enableDetection(false);
        assertThat(detector.isEnabled()).isFalse();
        assertThat(detector.scan()).isNotNull();
    }

    @Test
    void onePushOfABumperIsToldOnce() throws InterruptedException {
        AtomicInteger asked = new AtomicInteger();
        TouchFeatureDetector detector = new TouchFeatureDetector(() -> {
            int question = asked.incrementAndGet();
            return question <= 5 || question == 8;
        });
        detector.setDelay(1);
        detector.addListener((feature, source) -> found.offer(feature));
        found.take();
        found.take();
        assertThat(asked.get()).isGreaterThanOrEqualTo(8);
    }

    @Test
    void fusionReportsWhatAllFind() throws InterruptedException {
        FusorDetector fusor = new FusorDetector();
        fusor.addListener((feature, source) -> found.offer(feature));
        fusor.addDetector(new RangeFeatureDetector(ranges(0.1f), 0.5f, 1, 90));
        fusor.addDetector(new RangeFeatureDetector(ranges(9), 0.5f, 3, -90));
        assertThat(fusor.getDelay()).isEqualTo(3);
        assertThat(fusor.scan().getRangeReadings()).hasSize(1);
        assertThat(found.take().getRangeReading().getAngle()).isEqualTo(90);
    }

    @Test
    void featureLosesItsAngleOnTheWire() {
        RangeFeature feature = new RangeFeature(new RangeReading(30, 7));
        RangeFeature copy = Bytes.copy(feature, new RangeFeature(new RangeReading(0, 0)));
        assertThat(copy.getRangeReading().getRange()).isEqualTo(7);
        assertThat(copy.getRangeReading().getAngle()).isZero();
        assertThat(copy.getTimeStamp()).isEqualTo(feature.getTimeStamp());
        assertThat(copy.getRangeReadings()).hasSize(1);
    }

    private static RangeFinder ranges(float... ranges) {
        return new RangeFinder() {
            @Override
            public float getRange() {
                return ranges[0];
            }

            @Override
            public float[] getRanges() {
                return ranges;
            }
        };
    }
}
