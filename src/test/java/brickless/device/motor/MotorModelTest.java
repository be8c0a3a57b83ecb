package brickless.device.motor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.data.Percentage.withPercentage;

import brickless.world.MotorType;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** The model against the measurements it was derived from: within 3 %. */
class MotorModelTest {
    private static final double NEWTON_CENTIMETRES = 0.01;

    @ParameterizedTest
    @CsvSource({"LARGE,175,0.060", "MEDIUM,260,0.100", "NXT,170,0.060"})
    void freeMotorReachesTheMeasuredSpeedAndCurrent(MotorType type, double rpm, double amperes) {
        MotorBench bench = new MotorBench(type, 9);
        bench.motor.drive(100);
        bench.processor.runMillis(1000);
        assertThat(bench.rpm()).isCloseTo(rpm, withPercentage(3));
        assertThat(bench.motor.amperes()).isCloseTo(amperes, withPercentage(3));
    }

    @ParameterizedTest
    @CsvSource({"LARGE,17.3,105,0.69", "MEDIUM,6.64,165,0.37", "NXT,16.7,117,0.55"})
    void loadedMotorRunsAtTheMeasuredPoint(MotorType type, double torque, double rpm, double amperes) {
        MotorBench bench = new MotorBench(type, 9);
        bench.shaft.setLoadTorque(-torque * NEWTON_CENTIMETRES);
        bench.motor.drive(100);
        bench.processor.runMillis(1000);
        assertThat(bench.rpm()).isCloseTo(rpm, withPercentage(3));
        assertThat(bench.motor.amperes()).isCloseTo(amperes, withPercentage(3));
    }

    @Test
    void largeMotorStallsAtTheMeasuredTorqueAndCurrent() {
        MotorBench bench = new MotorBench(MotorType.LARGE, 9);
        bench.block();
        bench.motor.drive(100);
        bench.processor.runMillis(200);
        assertThat(bench.rpm()).isZero();
        assertThat(bench.motor.amperes()).isCloseTo(1.64, withPercentage(3));
        MotorConstants constants = MotorConstants.of(MotorType.LARGE);
        double torque = constants.torqueConstant() * bench.motor.amperes() - constants.frictionNewtonMetres();
        assertThat(torque).isCloseTo(0.43, withPercentage(3));
    }

    @ParameterizedTest
    @CsvSource({"LARGE,0.275,0.473,5.5,0.0165", "MEDIUM,0.246,0.291,10.7,0.0246", "NXT,0.341,0.487,5.5,0.0204"})
    void constantsAreThoseOfTheArithmetic(MotorType type, double kt, double ke, double ohms, double friction) {
        MotorConstants constants = MotorConstants.of(type);
        assertThat(constants.torqueConstant()).isCloseTo(kt, withPercentage(1));
        assertThat(constants.backEmfConstant()).isCloseTo(ke, withPercentage(1));
        assertThat(constants.resistanceOhms()).isCloseTo(ohms, withPercentage(1));
        assertThat(constants.frictionNewtonMetres()).isCloseTo(friction, withPercentage(1));
    }

    @Test
    void encoderCountsWholeDegreesOfTheShaft() {
        MotorBench bench = new MotorBench(MotorType.LARGE, 9);
        for (int i = 0; i < 300; i++) {
            bench.motor.drive(i < 150 ? 30 : -45);
            bench.processor.runMillis(2);
            assertThat((double) bench.motor.encoder())
                    .isCloseTo(Math.toDegrees(bench.shaft.angleRadians()), within(0.5000001));
        }
    }

    @Test
    void mediumMotorStallsBetween15And18NewtonCentimetres() {
        MotorBench weak = new MotorBench(MotorType.MEDIUM, 9);
        weak.shaft.setLoadTorque(-15 * NEWTON_CENTIMETRES);
        weak.motor.drive(100);
        weak.processor.runMillis(500);
        assertThat(weak.rpm()).isPositive();
        MotorBench strong = new MotorBench(MotorType.MEDIUM, 9);
        strong.shaft.setLoadTorque(-18 * 1.03 * NEWTON_CENTIMETRES);
        strong.motor.drive(100);
        strong.processor.runMillis(500);
        assertThat(strong.rpm()).isNotPositive();
    }

    @Test
    void largeMotorTakesItsTimeConstantToReach63Percent() {
        MotorBench bench = new MotorBench(MotorType.LARGE, 9);
        bench.motor.drive(100);
        bench.processor.runMillis(60);
        assertThat(bench.rpm()).isCloseTo(175 * 0.632, withPercentage(3));
    }

    @Test
    void brakingStopsSoonerThanCoasting() {
        assertThat(degreesAfter(true)).isLessThan(0.6 * degreesAfter(false));
    }

    private static double degreesAfter(boolean brake) {
        MotorBench bench = new MotorBench(MotorType.LARGE, 8);
        bench.motor.drive(100);
        bench.processor.runMillis(500);
        double start = Math.toDegrees(bench.shaft.angleRadians());
        if (brake) {
            bench.motor.brake();
        } else {
            bench.motor.coast();
        }
        bench.processor.runMillis(3000);
        assertThat(bench.rpm()).isZero();
        return Math.toDegrees(bench.shaft.angleRadians()) - start;
    }

    @Test
    void coastingMotorDrawsNoCurrent() {
        MotorBench bench = new MotorBench(MotorType.LARGE, 8);
        bench.motor.drive(100);
        bench.processor.runMillis(300);
        bench.motor.coast();
        bench.processor.runMillis(20);
        assertThat(bench.rpm()).isPositive();
        assertThat(bench.motor.amperes()).isZero();
    }

    @Test
    void brakingMotorDrivesCurrentThroughTheShort() {
        MotorBench bench = new MotorBench(MotorType.LARGE, 8);
        bench.motor.drive(100);
        bench.processor.runMillis(300);
        bench.motor.brake();
        bench.processor.runMillis(4);
        assertThat(bench.motor.amperes()).isNegative();
        assertThat(bench.motor.batteryAmperes()).isZero();
    }

    @ParameterizedTest
    @EnumSource(MotorType.class)
    void littleDutyDoesNotMoveAStandingMotor(MotorType type) {
        MotorBench bench = new MotorBench(type, 8.2);
        bench.motor.drive(5);
        bench.processor.runMillis(500);
        assertThat(bench.shaft.angleRadians()).isZero();
    }

    @Test
    void tenPercentMovesTheLargeMotor() {
        MotorBench bench = new MotorBench(MotorType.LARGE, 8.2);
        bench.motor.drive(10);
        bench.processor.runMillis(500);
        assertThat(bench.motor.encoder()).isPositive();
    }

    @Test
    void directionsAreMirrorImages() {
        MotorBench forward = new MotorBench(MotorType.LARGE, 8);
        MotorBench backward = new MotorBench(MotorType.LARGE, 8);
        forward.motor.drive(70);
        backward.motor.drive(-70);
        forward.processor.runMillis(1234);
        backward.processor.runMillis(1234);
        assertThat(backward.shaft.angleRadians()).isEqualTo(-forward.shaft.angleRadians());
    }

    @Test
    void dutyBeyondFullIsClamped() {
        MotorBench bench = new MotorBench(MotorType.LARGE, 9);
        bench.motor.drive(300);
        bench.processor.runMillis(1000);
        assertThat(bench.rpm()).isCloseTo(175, withPercentage(3));
    }

    @Test
    void emptyPortAcceptsEverythingAndNeverTurns() {
        MotorBench bench = new MotorBench(MotorType.LARGE, 8);
        bench.motor.plug(null);
        bench.motor.drive(100);
        bench.processor.runMillis(300);
        assertThat(bench.motor.tachoDegrees()).isZero();
        assertThat(bench.motor.connected()).isEqualTo("none");
        assertThat(bench.motor.amperes()).isZero();
    }

    @Test
    void halvingTheStepChangesTheAngleByLessThanOnePercent() {
        double coarse = angleAfterPulse(2_000_000);
        assertThat(angleAfterPulse(1_000_000)).isCloseTo(coarse, withPercentage(1));
        assertThat(angleAfterPulse(500_000)).isCloseTo(coarse, withPercentage(1));
    }

    private static double angleAfterPulse(long stepNanos) {
        MotorBench bench = new MotorBench(MotorType.LARGE, 8, stepNanos);
        bench.motor.drive(80);
        bench.processor.runMillis(200);
        bench.motor.coast();
        bench.processor.runMillis(2000);
        return bench.shaft.angleRadians();
    }
}
