package lejos.robotics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import lejos.robotics.navigation.RotateMoveController;
import org.junit.jupiter.api.Test;

class AdapterTest {
    @Test
    void rangeIsInCentimetresAndRangesAreInMetres() {
        RangeFinder finder = new RangeFinderAdapter(sample(0.5f, 2));
        assertThat(finder.getRange()).isEqualTo(50);
        assertThat(finder.getRanges()).containsExactly(0.5f, 2);
    }

    @Test
    void nothingInSightStaysInfinite() {
        assertThat(new RangeFinderAdapter(sample(Float.POSITIVE_INFINITY)).getRange()).isInfinite();
    }

    @Test
    void accelerationsLoseTheirFractions() {
        Accelerometer accelerometer = new AccelerometerAdapter(sample(1.9f, -2.9f, 1000));
        assertThat(accelerometer.getXAccel()).isEqualTo(1);
        assertThat(accelerometer.getYAccel()).isEqualTo(-2);
        assertThat(accelerometer.getZAccel()).isEqualTo(1000);
    }

    @Test
    void headingsCountFromTheZeroDirection() {
        float[] heading = {350};
        DirectionFinderAdapter finder = new DirectionFinderAdapter(live(heading));
        assertThat(finder.getDegreesCartesian()).isEqualTo(350);
        finder.resetCartesianZero();
        heading[0] = 20;
        assertThat(finder.getDegreesCartesian()).isEqualTo(30);
    }

    @Test
    void anyAxisOfAGyroscopeCanBeUsed() {
        assertThat(new GyroscopeAdapter(sample(1, 2, 3), 100, 2).getAngularVelocity()).isEqualTo(3);
    }

    @Test
    void onlyLightSensorsDetectLight() {
        assertThatThrownBy(() -> new LightDetectorAdaptor(sample(1))).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void headLooksAtAllAnglesAndTurnsBack() {
        MotorLog head = new MotorLog(Map.of());
        RotatingRangeScanner scanner = new RotatingRangeScanner(head.as(RegulatedMotor.class),
                new RangeFinderAdapter(sample(0.5f)), 3);
        scanner.setAngles(new float[] {-45, 45.9f});
        RangeReadings readings = scanner.getRangeValues();
        assertThat(head.calls()).containsExactly("resetTachoCount[]", "rotateTo[-135]", "rotateTo[135]", "rotateTo[0]");
        assertThat(readings.getRange(1)).isEqualTo(52);
        assertThat(readings.getAngle(0)).isEqualTo(-45);
        assertThat(scanner.getRangeValues()).isSameAs(readings);
    }

    @Test
    void readingTooFarIsInvalid() {
        RangeScanner scanner = new RotatingRangeScanner(new MotorLog(Map.of()).as(RegulatedMotor.class),
                new RangeFinderAdapter(sample(1.79f)));
        assertThat(scanner.getRangeValues().incomplete()).isTrue();
        assertThat(scanner.getRangeValues()).hasSize(2);
    }

    @Test
    void robotTurnsTheShortWayToEachAngle() {
        MotorLog pilot = new MotorLog(Map.of());
        FixedRangeScanner scanner = new FixedRangeScanner(pilot.as(RotateMoveController.class),
                new RangeFinderAdapter(sample(0.5f)));
        scanner.setAngles(new float[] {-170, 170});
        assertThat(scanner.getRangeValues().getRange(170f)).isEqualTo(52);
        assertThat(pilot.calls()).containsExactly("rotate[-170.0, false]", "rotate[-20.0, false]",
                "rotate[-170.0, false]");
    }

    @Test
    void colorWithoutNumberSaysZeroAsInLejos() {
        assertThat(new Color(1, 2, 3).getColor()).isEqualTo(Color.RED);
        assertThat(new Color(1, 2, 3, Color.BROWN).getColor()).isEqualTo(Color.BROWN);
    }

    @Test
    void missingReadingIsMinusOne() {
        RangeReadings readings = new RangeReadings(1);
        assertThat(readings.getRange(45f)).isEqualTo(-1);
        assertThat(readings.incomplete()).isTrue();
        assertThat(new RangeReadings(0).incomplete()).isFalse();
    }

    private static SampleProvider sample(float... values) {
        return live(values);
    }

    private static SampleProvider live(float[] values) {
        return new SampleProvider() {
            @Override
            public int sampleSize() {
                return values.length;
            }

            @Override
            public void fetchSample(float[] sample, int offset) {
                System.arraycopy(values, 0, sample, offset, values.length);
            }
        };
    }
}
