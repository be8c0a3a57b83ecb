package brickless.device.motor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import brickless.hardware.MotorRegulation;
import brickless.hardware.MotorSnapshot;
import brickless.hardware.MoveRequest;
import brickless.hardware.RegulationState;
import brickless.hardware.RegulationTuning;
import brickless.world.MotorType;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * The controller on a modelled motor: durations, settling, stall, hold and float as sheet "motor" sections 4 to 7 tell.
 */
class RegulationTest {
    private static final int ENDLESS = MotorRegulation.NO_LIMIT;
    private final MotorBench bench = new MotorBench(MotorType.LARGE, 8);

    private static MoveRequest to(float speed, int limit) {
        return new MoveRequest(speed, 6000, limit, true);
    }

    private static MoveRequest stop(boolean hold) {
        return new MoveRequest(0, 6000, ENDLESS, hold);
    }

    @ParameterizedTest
    @CsvSource({"90,360,4.17", "360,360,1.18", "720,360,0.72", "2000,3600,4.3"})
    void rotationsTakeAsLongAsOnTheBrick(float speed, int angle, double seconds) {
        bench.motor.move(to(speed, angle));
        bench.motor.awaitStandstill();
        assertThat(bench.seconds()).isCloseTo(seconds, offset(0.25));
        MotorSnapshot end = bench.motor.observe();
        assertThat(end.state()).isEqualTo(RegulationState.HOLD);
        assertThat(end.tachoDegrees()).isBetween(angle - 2, angle + 2);
        assertThat(end.positionDegrees()).isEqualTo(angle);
    }

    @ParameterizedTest
    @EnumSource(MotorType.class)
    void everyMotorTypeArrivesWithinTwoDegrees(MotorType type) {
        MotorBench own = new MotorBench(type, 8.2);
        if (type == MotorType.MEDIUM) {
            own.motor.configure(new RegulationTuning(8, 0.04f, 8, 8, 0.02f, 0, 10));
        }
        own.motor.move(to(360, -720));
        own.motor.awaitStandstill();
        own.processor.runMillis(1500);
        assertThat(own.motor.encoder()).isBetween(-722, -718);
        assertThat(own.degreesPerSecond()).isCloseTo(0, offset(1.0));
    }

    @Test
    void stopFromCruiseTakesRampAndSettling() {
        bench.motor.move(to(360, ENDLESS));
        bench.processor.runMillis(1000);
        double start = bench.seconds();
        bench.motor.move(stop(true));
        bench.motor.awaitStandstill();
        assertThat(bench.seconds() - start).isCloseTo(0.18, offset(0.05));
    }

    @Test
    void stopOfAnIdleMotorReturnsAtOnce() {
        bench.motor.move(stop(true));
        bench.motor.awaitStandstill();
        assertThat(bench.seconds()).isLessThan(0.002);
        assertThat(bench.motor.state()).isEqualTo(RegulationState.HOLD);
    }

    @Test
    void movingStateIsReportedWhenMoveReturns() {
        bench.motor.move(to(360, 90));
        assertThat(bench.motor.snapshot().state().moving()).isTrue();
    }

    @Test
    void phasesFollowEachOther() {
        bench.motor.move(to(360, 360));
        assertThat(bench.motor.state()).isEqualTo(RegulationState.START);
        bench.processor.runMillis(30);
        assertThat(bench.motor.state()).isEqualTo(RegulationState.ACCEL);
        bench.processor.runMillis(500);
        assertThat(bench.motor.state()).isEqualTo(RegulationState.MOVE);
        bench.processor.runMillis(500);
        assertThat(bench.motor.state()).isEqualTo(RegulationState.DECEL);
        bench.processor.runMillis(600);
        assertThat(bench.motor.state()).isEqualTo(RegulationState.HOLD);
    }

    @Test
    void cruisingMotorRunsAtTheRequestedSpeed() {
        bench.motor.move(to(360, ENDLESS));
        bench.processor.runMillis(1500);
        assertThat(bench.degreesPerSecond()).isCloseTo(360, offset(8.0));
        assertThat(bench.motor.observe().velocityDegreesPerSecond()).isEqualTo(360);
    }

    @Test
    void blockedMotorStallsAfterLagAndStallTime() {
        bench.block();
        bench.motor.move(to(360, 3600));
        bench.motor.awaitStandstill();
        assertThat(bench.seconds()).isBetween(1.1, 1.25);
        assertThat(bench.motor.state()).isEqualTo(RegulationState.STALL);
        assertThat(bench.motor.state().moving()).isFalse();
        assertThat(bench.motor.observe().positionDegrees()).isZero();
    }

    @Test
    void stallThresholdAppliesFromTheNextMove() {
        bench.block();
        bench.motor.move(to(360, 3600));
        bench.motor.setStallThreshold(10, 100);
        bench.motor.awaitStandstill();
        assertThat(bench.seconds()).isGreaterThan(1.1);
        double start = bench.seconds();
        bench.motor.move(to(360, 3600));
        bench.motor.awaitStandstill();
        assertThat(bench.seconds() - start).isBetween(0.1, 0.25);
    }

    @Test
    void unreachableSpeedNeverStalls() {
        bench.motor.move(to(2000, ENDLESS));
        bench.processor.runMillis(10_000);
        assertThat(bench.motor.state().moving()).isTrue();
        assertThat(bench.degreesPerSecond()).isBetween(850.0, 950.0);
        MotorSnapshot now = bench.motor.observe();
        assertThat((double) now.positionDegrees() - now.tachoDegrees()).isBetween(40.0, 65.0);
    }

    @Test
    void holdResistsATorque() {
        bench.motor.move(stop(true));
        bench.shaft.setLoadTorque(0.1);
        bench.processor.runMillis(2000);
        assertThat(bench.motor.encoder()).isBetween(0, 15);
        assertThat(bench.degreesPerSecond()).isCloseTo(0, offset(1.0));
        assertThat(bench.motor.observe().positionDegrees()).isZero();
    }

    @Test
    void floatingMotorGivesWayAndCounts() {
        bench.motor.move(to(360, 90));
        bench.motor.awaitStandstill();
        bench.motor.move(stop(false));
        assertThat(bench.motor.state()).isEqualTo(RegulationState.IDLE);
        bench.shaft.setLoadTorque(0.1);
        bench.processor.runMillis(500);
        assertThat(bench.motor.encoder()).isGreaterThan(200);
        assertThat(bench.motor.observe().positionDegrees()).isEqualTo(bench.motor.encoder());
    }

    @Test
    void floatingAfterMotionDeceleratesFirst() {
        bench.motor.move(to(360, ENDLESS));
        bench.processor.runMillis(500);
        bench.motor.move(stop(false));
        assertThat(bench.motor.state().moving()).isTrue();
        bench.motor.awaitStandstill();
        assertThat(bench.motor.state()).isEqualTo(RegulationState.IDLE);
        assertThat(bench.motor.dutyPercent()).isZero();
    }

    @Test
    void reversingBlendsWithoutAStop() {
        bench.motor.move(to(360, ENDLESS));
        bench.processor.runMillis(500);
        bench.motor.move(to(360, -ENDLESS));
        for (int i = 0; i < 50; i++) {
            bench.processor.runMillis(10);
            assertThat(bench.motor.state().moving()).isTrue();
        }
        assertThat(bench.degreesPerSecond()).isCloseTo(-360, offset(10.0));
    }

    @Test
    void speedCanBeChangedWhileRunning() {
        bench.motor.move(to(360, ENDLESS));
        bench.processor.runMillis(500);
        bench.motor.adjustSpeed(180);
        bench.processor.runMillis(800);
        assertThat(bench.degreesPerSecond()).isCloseTo(180, offset(8.0));
    }

    @Test
    void speedIsNotChangedInTheFinalDeceleration() {
        bench.motor.move(new MoveRequest(360, 400, 360, true));
        bench.processor.runMillis(1100);
        assertThat(bench.motor.state()).isEqualTo(RegulationState.DECEL);
        float before = bench.motor.observe().velocityDegreesPerSecond();
        bench.motor.adjustSpeed(700);
        bench.processor.runMillis(8);
        assertThat(bench.motor.observe().velocityDegreesPerSecond()).isLessThan(before);
    }

    @Test
    void speedZeroLatches() {
        bench.motor.move(to(360, ENDLESS));
        bench.processor.runMillis(500);
        bench.motor.adjustSpeed(0);
        bench.motor.awaitStandstill();
        bench.motor.adjustSpeed(300);
        bench.processor.runMillis(500);
        assertThat(bench.motor.state()).isEqualTo(RegulationState.HOLD);
    }

    @Test
    void resettingTheTachoKeepsTheRunningTarget() {
        bench.motor.move(to(360, 720));
        bench.processor.runMillis(1000);
        int before = bench.motor.encoder();
        bench.motor.resetTacho();
        bench.motor.awaitStandstill();
        assertThat(bench.motor.encoder()).isCloseTo(720 - before, offset(3));
        assertThat(Math.toDegrees(bench.shaft.angleRadians())).isCloseTo(720, offset(3.0));
    }

    @Test
    void rawCommandEndsRegulationAndWakesWaiters() {
        bench.motor.move(to(360, ENDLESS));
        bench.processor.runMillis(100);
        bench.motor.drive(30);
        bench.motor.awaitStandstill();
        assertThat(bench.motor.state()).isEqualTo(RegulationState.IDLE);
        bench.processor.runMillis(500);
        assertThat(bench.degreesPerSecond()).isPositive();
    }

    @Test
    void releaseForgetsEverything() {
        bench.motor.setStallThreshold(5, 10);
        bench.motor.move(to(360, ENDLESS));
        bench.processor.runMillis(300);
        bench.motor.release();
        bench.processor.runMillis(2000);
        assertThat(bench.degreesPerSecond()).isZero();
        bench.block();
        double start = bench.seconds();
        bench.motor.move(to(360, 36000));
        bench.motor.awaitStandstill();
        assertThat(bench.seconds() - start).isGreaterThan(1.1);
    }

    @Test
    void everyCallChargesTheProcessor() {
        long before = bench.processor.nowNanos();
        bench.motor.tachoDegrees();
        assertThat(bench.processor.nowNanos()).isGreaterThan(before);
        before = bench.processor.nowNanos();
        bench.motor.move(to(100, 0));
        assertThat(bench.processor.nowNanos()).isGreaterThan(before);
    }
}
