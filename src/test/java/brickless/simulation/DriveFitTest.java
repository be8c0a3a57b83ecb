package brickless.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import brickless.loading.hints.HardwareHints;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DriveFitTest {
    @ParameterizedTest
    @CsvSource({"5.6, 10", "4.32, 10", "56, 1", "43.2, 1", "2.2, 25.4", "1.7, 25.4", "0.056, 1000", "5.5, 10", "3, 10", "8.16, 10", "81.6, 1"})
    void theUnitIsTheOneThatGivesATyreThatExists(double diameter, double millimetres) {
        assertThat(TyreSize.millimetresPerUnit(diameter)).isEqualTo(millimetres);
    }

    private static HardwareHints.Device large(String port, String name) {
        return new HardwareHints.Device(port, "EV3LargeRegulatedMotor", name);
    }

    @Test void declaredWheelsDecide() {
        HardwareHints hints = new HardwareHints(List.of(large("A", ""), large("D", "")), List.of(), List.of(
                new HardwareHints.Wheel("A", 4.32, OptionalDouble.of(6.5), OptionalDouble.empty(), 1, ""),
                new HardwareHints.Wheel("D", 4.32, OptionalDouble.of(-6.5), OptionalDouble.empty(), 1, "")));
        DriveFit fit = DriveFit.of(hints);
        assertThat(fit.left().port()).as("smaller offset is left").isEqualTo("D");
        assertThat(fit.left().diameterMillimetres()).isCloseTo(43.2, within(1e-9));
        assertThat(fit.trackMillimetres()).isCloseTo(130, within(1e-9));
    }

    @Test void namesTellLeftFromRight() {
        HardwareHints hints = new HardwareHints(List.of(large("A", "rightMotor"), large("D", "leftMotor")), List.of(), List.of());
        assertThat(DriveFit.of(hints).left().port()).isEqualTo("D");
        assertThat(DriveFit.of(hints).right().port()).isEqualTo("A");
    }

    @Test void aMediumMotorDoesNotDriveWhenTwoLargeOnesAreThere() {
        HardwareHints hints = new HardwareHints(List.of(new HardwareHints.Device("A", "EV3MediumRegulatedMotor", "claw"), large("B", ""),
                large("D", "")), List.of(), List.of());
        assertThat(DriveFit.of(hints).left().port() + DriveFit.of(hints).right().port()).isEqualTo("BD");
    }

    @Test void aProgramWithoutMotorsGetsTheUsualOnes() {
        DriveFit fit = DriveFit.of(new HardwareHints(List.of(), List.of(), List.of()));
        assertThat(fit).isEqualTo(new DriveFit(new DriveFit.Wheel("B", "large", 56, 1, false),
                new DriveFit.Wheel("C", "large", 56, 1, false), 120));
    }
}
