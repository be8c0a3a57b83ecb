package brickless.units;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class ConversionsTest {
    @Test
    void tyreDiameterInMillimetresBecomesMetres() {
        assertThat(Lengths.metresFromMillimetres(56)).isEqualTo(0.056);
        assertThat(Lengths.millimetresFromMetres(0.25)).isEqualTo(250);
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
    void noLoadSpeedOfTheLargeMotorInRadians() {
        assertThat(AngularSpeeds.radiansPerSecondFromRpm(175)).isCloseTo(18.325957145940461, within(1e-12));
    }
}
