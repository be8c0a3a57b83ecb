package lejos.hardware.sensor;

import static lejos.hardware.sensor.Samples.fetch;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import lejos.hardware.AttachedBrick;
import lejos.hardware.DeviceException;
import lejos.hardware.port.SensorPort;
import lejos.robotics.Color;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Conversion of raw readings, and which hardware mode each fetch needs. */
class EV3SensorsTest {
    private static final float INFINITY = Float.POSITIVE_INFINITY;

    @RegisterExtension
    final AttachedBrick brick = new AttachedBrick();

    private List<String> modes() {
        return brick.sensor(0).log().stream().filter(entry -> !entry.startsWith("expect")).toList();
    }

    private EV3UltrasonicSensor ultrasonic() {
        brick.sensor(0).plugUart(30, "ev3-ultrasonic", "US-DIST-CM", "US-DIST-IN", "US-LISTEN", "US-SI-CM", "US-SI-IN");
        return new EV3UltrasonicSensor(SensorPort.S1);
    }

    private EV3ColorSensor colour() {
        brick.sensor(0).plugUart(29, "ev3-color", "COL-REFLECT", "COL-AMBIENT", "COL-COLOR", "REF-RAW", "RGB-RAW",
                "COL-CAL");
        return new EV3ColorSensor(SensorPort.S1);
    }

    private EV3GyroSensor gyro() {
        brick.sensor(0).plugUart(32, "ev3-gyro", "GYRO-ANG", "GYRO-RATE", "GYRO-FAS", "GYRO-G&A", "GYRO-CAL");
        return new EV3GyroSensor(SensorPort.S1);
    }

    private EV3IRSensor infrared() {
        brick.sensor(0).plugUart(33, "ev3-infrared", "IR-PROX", "IR-SEEK", "IR-REMOTE");
        return new EV3IRSensor(SensorPort.S1);
    }

    @ParameterizedTest
    @CsvSource({"0,0", "2047,0", "2048,1", "4095,1"})
    void touchIsPressedAboveHalfTheReference(int raw, float expected) {
        EV3TouchSensor touch = new EV3TouchSensor(SensorPort.S1);
        brick.sensor(0).analog().raw(4095 - raw, raw);
        assertEquals(expected, fetch(touch)[0]);
        assertEquals(expected, fetch(touch.getTouchMode())[0]);
        assertEquals(List.of("Touch"), touch.getAvailableModes());
        assertTrue(modes().contains("type 9"));
    }

    @ParameterizedTest
    @CsvSource({"0,0", "123,0.123", "255,0.25500003", "1000,1", "2549,2.549", "2550,Infinity"})
    void distanceIsInMetres(int millimetres, float expected) {
        EV3UltrasonicSensor sensor = ultrasonic();
        brick.sensor(0).uart().shorts(0, millimetres);
        assertEquals(expected, fetch(sensor)[0]);
        assertEquals(expected, fetch(sensor.getDistanceMode())[0]);
        assertEquals(expected, fetch(sensor.getMode("Distance"))[0]);
        assertEquals(List.of("initialise 0"), modes());
    }

    @Test
    void listeningUsesTheThirdHardwareMode() {
        EV3UltrasonicSensor sensor = ultrasonic();
        brick.sensor(0).uart().bytes(2, 1);
        assertEquals(1, fetch(sensor.getListenMode())[0]);
        brick.sensor(0).uart().bytes(2, 0);
        assertEquals(0, fetch(sensor.getMode("Listen"))[0]);
        assertEquals(List.of("initialise 0", "mode 2"), modes());
    }

    @Test
    void alternatingModesSwitchTheHardwareEveryTime() {
        EV3UltrasonicSensor sensor = ultrasonic();
        for (int i = 0; i < 2; i++) {
            fetch(sensor.getListenMode());
            fetch(sensor.getDistanceMode());
        }
        assertEquals(List.of("initialise 0", "mode 2", "mode 0", "mode 2", "mode 0"), modes());
    }

    @Test
    void aFetchEnablesADisabledSensor() {
        EV3UltrasonicSensor sensor = ultrasonic();
        assertTrue(sensor.isEnabled());
        sensor.disable();
        assertFalse(sensor.isEnabled());
        fetch(sensor);
        assertTrue(sensor.isEnabled());
        sensor.disable();
        sensor.enable();
        assertEquals(List.of("initialise 0", "mode 3", "mode 0", "mode 3", "mode 0"), modes());
    }

    @Test
    void selectingAModeDoesNotSwitchUntilTheFetch() {
        EV3UltrasonicSensor sensor = ultrasonic();
        sensor.setCurrentMode("Listen");
        assertEquals(1, sensor.getCurrentMode());
        assertEquals(List.of("initialise 0"), modes());
        fetch(sensor);
        assertEquals(List.of("initialise 0", "mode 2"), modes());
    }

    @ParameterizedTest
    @CsvSource({"0,-1", "1,7", "2,2", "3,1", "4,3", "5,0", "6,6", "7,13", "8,-1", "255,-1"})
    void colourIdsBecomeColorConstants(int raw, int expected) {
        EV3ColorSensor sensor = colour();
        brick.sensor(0).uart().bytes(2, raw);
        assertEquals(expected, fetch(sensor)[0]);
        assertEquals(expected, fetch(sensor.getColorIDMode())[0]);
        assertEquals(expected, sensor.getColorID());
        assertEquals(List.of("initialise 0", "mode 2"), modes());
    }

    @ParameterizedTest
    @CsvSource({"0,0", "1,0.01", "50,0.5", "100,1"})
    void reflectedAndAmbientLightAreShares(int raw, float expected) {
        EV3ColorSensor sensor = colour();
        brick.sensor(0).uart().bytes(0, raw);
        brick.sensor(0).uart().bytes(1, raw);
        assertEquals(expected, fetch(sensor.getRedMode())[0]);
        assertEquals(expected, fetch(sensor.getAmbientMode())[0]);
    }

    @Test
    void rgbIsRedGreenBlue() {
        EV3ColorSensor sensor = colour();
        brick.sensor(0).uart().shorts(4, 1020, 510, 0);
        assertArrayEquals(new float[] {1, 0.5f, 0}, fetch(sensor.getRGBMode()));
        float[] sample = {9, 9, 9, 9, 9};
        sensor.getMode("RGB").fetchSample(sample, 1);
        assertArrayEquals(new float[] {9, 1, 0.5f, 0, 9}, sample);
        assertEquals(List.of("ColorID", "Red", "RGB", "Ambient"), sensor.getAvailableModes());
    }

    @Test
    void theLampBelongsToTheMode() {
        EV3ColorSensor sensor = colour();
        assertEquals(Color.RED, sensor.getFloodlight());
        assertTrue(sensor.isFloodlightOn());
        fetch(sensor.getAmbientMode());
        assertEquals(Color.BLUE, sensor.getFloodlight());
        fetch(sensor.getRGBMode());
        assertEquals(Color.WHITE, sensor.getFloodlight());
        fetch(sensor.getColorIDMode());
        assertEquals(Color.WHITE, sensor.getFloodlight());
    }

    @ParameterizedTest
    @CsvSource({"2,mode 1", "6,mode 2", "-1,reset"})
    void settingTheLampSwitchesTheMode(int color, String command) {
        EV3ColorSensor sensor = colour();
        assertTrue(sensor.setFloodlight(color));
        assertEquals(color, sensor.getFloodlight());
        assertEquals(color != Color.NONE, sensor.isFloodlightOn());
        assertEquals(List.of("initialise 0", command), modes());
        assertTrue(sensor.setFloodlight(Color.RED));
        assertEquals(Color.RED, sensor.getFloodlight());
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 3, 4, 5, 7, 13, -2, 14})
    void otherLampsAreRefused(int color) {
        EV3ColorSensor sensor = colour();
        var refusal = assertThrows(IllegalArgumentException.class, () -> sensor.setFloodlight(color));
        assertEquals("Invalid color specified", refusal.getMessage());
    }

    @Test
    void aFetchTurnsTheLampOnAgain() {
        EV3ColorSensor sensor = colour();
        sensor.setFloodlight(false);
        assertFalse(sensor.isFloodlightOn());
        fetch(sensor.getRedMode());
        assertTrue(sensor.isFloodlightOn());
        sensor.setFloodlight(true);
        assertEquals(List.of("initialise 0", "reset", "initialise 0"), modes());
    }

    @Test
    void turningLeftIsPositive() {
        EV3GyroSensor sensor = gyro();
        brick.sensor(0).uart().shorts(3, -90, 45);
        assertArrayEquals(new float[] {90}, fetch(sensor.getAngleMode()));
        assertArrayEquals(new float[] {-45}, fetch(sensor.getRateMode()));
        assertArrayEquals(new float[] {90, -45}, fetch(sensor.getAngleAndRateMode()));
        assertArrayEquals(new float[] {-45}, fetch(sensor), "the gyro itself delivers its rate");
        assertEquals(List.of("Rate", "Angle", "Angle and Rate"), sensor.getAvailableModes());
    }

    @ParameterizedTest
    @CsvSource({"32767,-32767", "-32767,32767", "-32768,32768", "0,-0.0"})
    void anglesUseAllSixteenBitsAndZeroIsNegative(int raw, float expected) {
        EV3GyroSensor sensor = gyro();
        brick.sensor(0).uart().shorts(3, raw, raw);
        assertEquals(Float.floatToIntBits(expected), Float.floatToIntBits(fetch(sensor.getAngleMode())[0]));
        assertEquals(Float.floatToIntBits(expected), Float.floatToIntBits(fetch(sensor.getRateMode())[0]));
    }

    @Test
    void gyroModesShareOneHardwareModeAndResetSwitchesTwice() {
        EV3GyroSensor sensor = gyro();
        fetch(sensor.getAngleMode());
        fetch(sensor.getRateMode());
        fetch(sensor.getAngleAndRateMode());
        sensor.reset();
        assertEquals(List.of("initialise 3", "mode 1", "mode 3"), modes());
    }

    @ParameterizedTest
    @CsvSource({"0,0", "4,0", "5,5", "30,30", "55,55", "56,Infinity", "100,Infinity"})
    void infraredDistanceIsNotInMetres(int raw, float expected) {
        EV3IRSensor sensor = infrared();
        brick.sensor(0).uart().bytes(0, raw);
        assertEquals(expected, fetch(sensor)[0]);
        assertEquals(expected, fetch(sensor.getDistanceMode())[0]);
    }

    @Test
    void seekDeliversBearingAndDistanceOfEveryChannel() {
        EV3IRSensor sensor = infrared();
        brick.sensor(0).uart().bytes(1, -25, 100, 25, 0, 3, 128, 0, 128);
        assertArrayEquals(new float[] {-25, 100, 25, 0, 0, INFINITY, 0, INFINITY}, fetch(sensor.getSeekMode()));
    }

    @Test
    void remoteCommandsAreReadByChannel() {
        EV3IRSensor sensor = infrared();
        brick.sensor(0).uart().bytes(2, 1, 11, 0, 9);
        assertEquals(1, sensor.getRemoteCommand(0));
        assertEquals(11, sensor.getRemoteCommand(1));
        assertEquals(9, sensor.getRemoteCommand(3));
        byte[] commands = new byte[5];
        sensor.getRemoteCommands(commands, 1, 4);
        assertArrayEquals(new byte[] {0, 1, 11, 0, 9}, commands);
        assertThrows(ArrayIndexOutOfBoundsException.class, () -> sensor.getRemoteCommand(4));
        assertThrows(ArrayIndexOutOfBoundsException.class, () -> sensor.getRemoteCommand(-1));
        fetch(sensor.getDistanceMode());
        assertEquals(List.of("initialise 0", "mode 2", "mode 0"), modes());
    }

    @Test
    void gettersDeliverTheSameObjectEveryTime() {
        EV3IRSensor sensor = infrared();
        assertSame(sensor.getSeekMode(), sensor.getMode("Seek"));
        assertSame(sensor.getSeekMode(), sensor.getSeekMode());
    }

    @Test
    void aSensorWithoutTheWantedModeSaysSo() {
        brick.sensor(0).plugUart(32, "ev3-gyro", "GYRO-ANG", "GYRO-RATE", "GYRO-FAS", "GYRO-G&A");
        EV3ColorSensor sensor = new EV3ColorSensor(SensorPort.S1);
        var refusal = assertThrows(IllegalArgumentException.class, () -> fetch(sensor.getRGBMode()));
        assertEquals("Invalid sensor mode", refusal.getMessage());
    }

    @Test
    void aClosedSerialSensorThrows() {
        EV3UltrasonicSensor sensor = ultrasonic();
        sensor.close();
        assertThrows(IndexOutOfBoundsException.class, () -> fetch(sensor));
    }

    @Test
    void aSensorPluggedOutThrowsWithTheReason() {
        EV3UltrasonicSensor sensor = ultrasonic();
        brick.sensor(0).unplug();
        assertEquals("Sensor changed unable to reset",
                assertThrows(DeviceException.class, () -> fetch(sensor)).getMessage());
    }
}
