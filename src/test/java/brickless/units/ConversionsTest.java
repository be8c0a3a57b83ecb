package brickless.units;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class ConversionsTest {
    @Test
    void tyreDiameterInMillimetresBecomesMetres() {
        assertThat(Lengths.metresFromMillimetres(56)).isEqualTo(0.056);
        assertThat(Lengths.millimetresFromMetres(0.25)).isEqualTo(250);
    }

    @Test
    void trackWidthInCentimetresBecomesMetres() {
        assertThat(Lengths.metresFromCentimetres(12.5)).isEqualTo(0.125);
        assertThat(Lengths.centimetresFromMetres(1.5)).isEqualTo(150);
    }

    @Test
    void anInchIsExactly25Point4Millimetres() {
        assertThat(Lengths.metresFromInches(1)).isEqualTo(0.0254);
        assertThat(Lengths.inchesFromMetres(0.3048)).isCloseTo(12, within(1e-12));
    }

    @Test
    void degreesAndRadiansAgreeAtKnownAngles() {
        assertThat(Angles.radiansFromDegrees(180)).isEqualTo(Math.PI);
        assertThat(Angles.radiansFromDegrees(90)).isEqualTo(Math.PI / 2);
        assertThat(Angles.radiansFromDegrees(-45)).isEqualTo(-Math.PI / 4);
        assertThat(Angles.degreesFromRadians(1)).isCloseTo(57.29577951308232, within(1e-13));
        assertThat(Angles.degreesFromRadians(Math.PI)).isEqualTo(180);
    }

    @Test
    void directionsAreNormalisedToOneTurnWithPlusHalfTurnIncluded() {
        assertThat(Angles.normalizedRadians(3 * Math.PI / 2)).isCloseTo(-Math.PI / 2, within(1e-15));
        assertThat(Angles.normalizedRadians(-Math.PI)).isEqualTo(Math.PI);
        assertThat(Angles.normalizedRadians(0.25)).isEqualTo(0.25);
        assertThat(Angles.normalizedDegrees(540)).isEqualTo(180);
        assertThat(Angles.normalizedDegrees(-180)).isEqualTo(180);
        assertThat(Angles.normalizedDegrees(361)).isEqualTo(1);
        assertThat(Angles.normalizedDegrees(-350)).isEqualTo(10);
    }

    @Test
    void noLoadSpeedOfTheLargeMotorInAllThreeUnits() {
        assertThat(AngularSpeeds.degreesPerSecondFromRpm(175)).isEqualTo(1050);
        assertThat(AngularSpeeds.rpmFromDegreesPerSecond(1050)).isEqualTo(175);
        assertThat(AngularSpeeds.radiansPerSecondFromRpm(175)).isCloseTo(18.325957145940461, within(1e-12));
        assertThat(AngularSpeeds.rpmFromRadiansPerSecond(2 * Math.PI)).isEqualTo(60);
        assertThat(AngularSpeeds.radiansPerSecondFromDegreesPerSecond(360)).isCloseTo(2 * Math.PI, within(1e-15));
        assertThat(AngularSpeeds.degreesPerSecondFromRadiansPerSecond(Math.PI)).isEqualTo(180);
    }

    @Test
    void secondsBecomeWholeNanoseconds() {
        assertThat(Times.nanosFromSeconds(0.002)).isEqualTo(2_000_000L);
        assertThat(Times.nanosFromSeconds(1e-10)).isZero();
        assertThat(Times.secondsFromNanos(1_500_000_000L)).isEqualTo(1.5);
        assertThat(Times.nanosFromSeconds(1e30)).isEqualTo(Long.MAX_VALUE);
    }

    @Test
    void millisecondsRoundDownLikeAClock() {
        assertThat(Times.nanosFromMilliseconds(25)).isEqualTo(25_000_000L);
        assertThat(Times.nanosFromMicroseconds(20)).isEqualTo(20_000L);
        assertThat(Times.millisecondsFromNanos(1_999_999L)).isEqualTo(1);
        assertThat(Times.millisecondsFromNanos(-1L)).isEqualTo(-1);
    }

    @Test
    void millisecondsBeyondTheRangeOfTheClockAreRefused() {
        assertThatThrownBy(() -> Times.nanosFromMilliseconds(Long.MAX_VALUE)).isInstanceOf(ArithmeticException.class);
    }
}
