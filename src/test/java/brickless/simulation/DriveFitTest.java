package brickless.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import brickless.loading.hints.HardwareHints;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DriveFitTest {
    @ParameterizedTest
    @CsvSource({"5.6, 10", "4.32, 10", "56, 1", "43.2, 1", "2.2, 25.4", "1.7, 25.4", "0.056, 1000", "5.5, 10", "3, 10",
            "8.16, 10", "81.6, 1"})
    void theUnitIsTheOneThatGivesATyreThatExists(double diameter, double millimetres) {
        assertThat(TyreSize.millimetresPerUnit(diameter)).isEqualTo(millimetres);
    }

    @Test
    void aTrackThatIsTooWideInOneUnitRulesThatUnitOut() {
        HardwareHints hints = new HardwareHints(List.of(), List.of(), List.of(
                new HardwareHints.Wheel("B", 3.28, OptionalDouble.empty(), OptionalDouble.of(19), 1, ""),
                new HardwareHints.Wheel("A", 3.28, OptionalDouble.empty(), OptionalDouble.of(19), 1, "")));
        DriveFit fit = DriveFit.of(hints);
        assertThat(fit.left().diameterMillimetres()).as("83 mm in inches, but then the axle had half a metre")
                .isCloseTo(32.8, within(1e-9));
        assertThat(fit.trackMillimetres()).isCloseTo(190, within(1e-9));
    }

    private static HardwareHints.Device large(String port, String name) {
        return new HardwareHints.Device(port, "EV3LargeRegulatedMotor", name);
    }

    @Test
    void declaredWheelsDecide() {
        HardwareHints hints = new HardwareHints(List.of(large("A", ""), large("D", "")), List.of(), List.of(
                new HardwareHints.Wheel("A", 4.32, OptionalDouble.of(6.5), OptionalDouble.empty(), 1, ""),
                new HardwareHints.Wheel("D", 4.32, OptionalDouble.of(-6.5), OptionalDouble.empty(), 1, "")));
        DriveFit fit = DriveFit.of(hints);
        assertThat(fit.left().port()).as("smaller offset is left").isEqualTo("D");
        assertThat(fit.left().diameterMillimetres()).isCloseTo(43.2, within(1e-9));
        assertThat(fit.trackMillimetres()).isCloseTo(130, within(1e-9));
    }

    @Test
    void namesTellLeftFromRight() {
        HardwareHints hints = new HardwareHints(List.of(large("A", "rightMotor"), large("D", "leftMotor")),
                List.of(), List.of());
        assertThat(DriveFit.of(hints).left().port()).isEqualTo("D");
        assertThat(DriveFit.of(hints).right().port()).isEqualTo("A");
    }

    @Test
    void aMediumMotorDoesNotDriveWhenTwoLargeOnesAreThere() {
        HardwareHints hints = new HardwareHints(
                List.of(new HardwareHints.Device("A", "EV3MediumRegulatedMotor", "claw"), large("B", ""),
                large("D", "")), List.of(), List.of());
        assertThat(DriveFit.of(hints).left().port() + DriveFit.of(hints).right().port()).isEqualTo("BD");
    }

    @Test
    void aProgramWithoutMotorsGetsTheUsualOnes() {
        DriveFit fit = DriveFit.of(new HardwareHints(List.of(), List.of(), List.of()));
        assertThat(fit).isEqualTo(new DriveFit(new DriveFit.Wheel("B", "large", 56, 1, false),
                new DriveFit.Wheel("C", "large", 56, 1, false), 120));
    }

    @ParameterizedTest
    @CsvSource({
        "WHEEL_RADIUS, 2.15, TRACK, 15.6, 43, 156", "wheelDiameter, 56, trackWidth, 130, 56, 130",
        "WHEEL_DIAMETER_CM, 5.6, AXLE_CM, 12, 56, 120",
        "wheelDiameterInMm, 68.8, wheelBase, 140, 68.8, 140", "diameter, 2.2, distanceBetweenWheels, 5, 55.88, 127",
        "x, 9, HALF_TRACK_MM, 60, 56, 120",
        "WHEEL_CIRCUMFERENCE, 17.6, track, 11.5, 56.02, 115", "turnRadius, 30, trackColor, 4, 56, 120",
        "raddurchmesser, 4.3, spurweite, 16, 43, 160"
    })
    void sizesInConstantsDecideWithoutAPilot(String wheelName, double wheel, String trackName, double track,
            double diameter, double width) {
        Map<String, Double> numbers = new LinkedHashMap<>();
        numbers.put("speed", 200.0);
        numbers.put(wheelName, wheel);
        numbers.put(trackName, track);
        DriveFit fit = DriveFit.of(new HardwareHints(List.of(large("B", ""), large("C", "")), List.of(), List.of(),
                List.of(), Set.of(), numbers));
        assertThat(fit.left().diameterMillimetres()).isCloseTo(diameter, within(0.01));
        assertThat(fit.trackMillimetres()).isCloseTo(width, within(0.01));
    }
}
