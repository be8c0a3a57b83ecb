package lejos.hardware.motor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import brickless.hardware.RegulationTuning;
import java.util.List;
import java.util.function.Function;
import lejos.hardware.AttachedBrick;
import lejos.hardware.DeviceException;
import lejos.hardware.port.MotorPort;
import lejos.hardware.port.Port;
import lejos.hardware.port.SensorPort;
import lejos.hardware.port.TachoMotorPort;
import lejos.internal.ev3.EV3IOPort;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Construction, constants, getters and closing of regulated motors. */
class RegulatedMotorStateTest {
    private static final RegulationTuning LARGE = new RegulationTuning(4, 0.04f, 10, 2, 0.02f, 8, 0);
    private static final RegulationTuning MEDIUM = new RegulationTuning(8, 0.04f, 8, 8, 0.02f, 0, 10);
    private static final RegulationTuning GLIDE_WHEEL = new RegulationTuning(3.5f, 0.01f, 3, 2.5f, 0, 0, 0);

    private static final List<Function<Port, BaseRegulatedMotor>> BY_PORT = List.of(
            EV3LargeRegulatedMotor::new, EV3MediumRegulatedMotor::new, NXTRegulatedMotor::new,
            MindsensorsGlideWheelMRegulatedMotor::new, MindsensorsGlideWheelXLRegulatedMotor::new);
    private static final List<Function<TachoMotorPort, BaseRegulatedMotor>> BY_OPEN_PORT = List.of(
            EV3LargeRegulatedMotor::new, EV3MediumRegulatedMotor::new, NXTRegulatedMotor::new,
            MindsensorsGlideWheelMRegulatedMotor::new, MindsensorsGlideWheelXLRegulatedMotor::new);
    private static final List<RegulationTuning> TUNINGS = List.of(LARGE, MEDIUM, LARGE, GLIDE_WHEEL, GLIDE_WHEEL);
    private static final List<Integer> SPEEDS = List.of(1050, 1560, 1020, 2430, 1320);
    private static final List<Port> PORTS = List.of(MotorPort.A, MotorPort.B, MotorPort.C, MotorPort.D);

    @RegisterExtension
    final AttachedBrick brick = new AttachedBrick();

    @Test
    void everyClassHasItsConstantsOnEveryPort() {
        for (int i = 0; i < 40; i++) {
            int kind = i % 5;
            int port = i / 5 % 4;
            Port where = PORTS.get(port);
            BaseRegulatedMotor motor = i < 20
                    ? BY_PORT.get(kind).apply(where)
                    : BY_OPEN_PORT.get(kind).apply(where.open(TachoMotorPort.class));
            assertEquals(TUNINGS.get(kind), brick.motor(port).tuning(), "case " + i);
            brick.get().setVolts(9);
            assertEquals(SPEEDS.get(kind) * 0.9f, motor.getMaxSpeed(), 0.001f, "case " + i);
            EV3IOPort.closeAll();
        }
    }

    @ParameterizedTest
    @CsvSource({"7.4,0,777", "7.8,0,819", "7.8,1,1216.8", "8.0,0,840", "9.0,0,945"})
    void maximumSpeedFollowsTheBattery(float volts, int kind, float expected) {
        BaseRegulatedMotor motor = BY_PORT.get(kind).apply(MotorPort.A);
        brick.get().setVolts(volts);
        assertEquals(expected, motor.getMaxSpeed(), 0.001f);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3, 4})
    void theSimulatorIsToldWhichMotorIsExpected(int kind) {
        BaseRegulatedMotor motor = BY_PORT.get(kind).apply(MotorPort.A);
        assertEquals("expect " + motor.getClass().getSimpleName(), brick.motor(0).log().get(0));
    }

    @Test
    void aSecondMotorOnThePortIsRefused() {
        new EV3LargeRegulatedMotor(MotorPort.B);
        var refusal = assertThrows(DeviceException.class, () -> new NXTRegulatedMotor(MotorPort.B));
        assertEquals("unable to open port", refusal.getMessage());
    }

    @Test
    void aSensorPortIsRefused() {
        var refusal = assertThrows(IllegalArgumentException.class, () -> new EV3LargeRegulatedMotor(SensorPort.S1));
        assertEquals("Invalid port interface", refusal.getMessage());
    }

    @ParameterizedTest
    @CsvSource({"123.6,124", "-200,200", "0,0", "2000,2000", "359.5,360"})
    void speedIsStoredWithoutSignOrLimit(float speed, int reported) {
        EV3LargeRegulatedMotor motor = new EV3LargeRegulatedMotor(MotorPort.A);
        motor.setSpeed(speed);
        assertEquals(reported, motor.getSpeed());
        motor.forward();
        assertEquals(Math.abs(speed), brick.motor(0).lastMove().speedDegreesPerSecond());
    }

    @Test
    void defaultsAre360And6000() {
        EV3LargeRegulatedMotor motor = new EV3LargeRegulatedMotor(MotorPort.A);
        assertEquals(360, motor.getSpeed());
        assertEquals(6000, motor.getAcceleration());
    }

    @Test
    void rotationSpeedIsTheSignedVelocityOfTheModel() {
        EV3LargeRegulatedMotor motor = new EV3LargeRegulatedMotor(MotorPort.A);
        motor.backward();
        brick.advance(30);
        assertEquals(-180, motor.getRotationSpeed());
        brick.advance(200);
        assertEquals(-360, motor.getRotationSpeed());
        motor.stop();
        assertEquals(0, motor.getRotationSpeed());
    }

    @Test
    void closingStopsFloatsAndFreesThePort() {
        EV3LargeRegulatedMotor motor = new EV3LargeRegulatedMotor(MotorPort.A);
        motor.forward();
        brick.advance(100);
        motor.close();
        motor.close();
        assertFalse(brick.motor(0).lastMove().hold());
        assertEquals(List.of("expect EV3LargeRegulatedMotor", "release"), brick.motor(0).log());
        new EV3LargeRegulatedMotor(MotorPort.A);
    }

    @Test
    void aPortGivenOpenStaysOpen() {
        TachoMotorPort port = MotorPort.A.open(TachoMotorPort.class);
        new EV3LargeRegulatedMotor(port).close();
        assertEquals(0, port.getTachoCount());
        assertThrows(DeviceException.class, () -> MotorPort.A.open(TachoMotorPort.class));
    }

    @Test
    void aNewMotorOnTheSamePortStartsWithTheHardwaresCount() {
        EV3LargeRegulatedMotor first = new EV3LargeRegulatedMotor(MotorPort.A);
        first.rotate(90);
        first.resetTachoCount();
        first.rotate(10);
        first.close();
        assertEquals(100, new EV3LargeRegulatedMotor(MotorPort.A).getTachoCount());
    }

    @Test
    void afterClosingReadsFailAndImmediateMovesAreIgnored() {
        EV3LargeRegulatedMotor motor = new EV3LargeRegulatedMotor(MotorPort.A);
        motor.close();
        int before = brick.motor(0).moves().size();
        motor.forward();
        motor.stop(true);
        assertEquals(before, brick.motor(0).moves().size());
        assertThrows(IndexOutOfBoundsException.class, motor::getTachoCount);
        assertThrows(IndexOutOfBoundsException.class, motor::stop);
    }

    @Test
    void anotherRegulatorCanBeGiven() {
        TachoMotorPort port = MotorPort.A.open(TachoMotorPort.class);
        MotorRegulator other = MotorPort.B.open(TachoMotorPort.class).getRegulator();
        BaseRegulatedMotor motor = new BaseRegulatedMotor(port, other, 9, 1, 0, 0, 1, 0, 0, 0, 1000) {};
        motor.forward();
        assertTrue(brick.motor(0).moves().isEmpty());
        assertEquals(1, brick.motor(1).moves().size());
    }
}
