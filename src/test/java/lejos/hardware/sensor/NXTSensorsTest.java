package lejos.hardware.sensor;

import static lejos.hardware.sensor.Samples.fetch;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import brickless.hardware.SensorSocket.Wiring;
import java.util.List;
import lejos.hardware.AttachedBrick;
import lejos.hardware.port.AnalogPort;
import lejos.hardware.port.SensorPort;
import lejos.robotics.Color;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** NXT and RCX sensors: conversion, lamps, commands. */
class NXTSensorsTest {
    private static final float INFINITY = Float.POSITIVE_INFINITY;

    @RegisterExtension
    final AttachedBrick brick = new AttachedBrick();

    private List<String> log() {
        return brick.sensor(0).log();
    }

    @ParameterizedTest
    @CsvSource({"0,1", "2047,1", "2048,0", "4095,0"})
    void nxtTouchPullsThePinDown(int raw, float expected) {
        NXTTouchSensor touch = new NXTTouchSensor(SensorPort.S1);
        brick.sensor(0).analog().raw(raw, 0);
        assertEquals(expected, fetch(touch)[0]);
        assertEquals(List.of("expect NXTTouchSensor", "type 1"), log());
    }

    @ParameterizedTest
    @CsvSource({"0,1", "1000,0.7558", "2048,0.49988", "4095,0"})
    void lightRisesAsTheVoltageFalls(int raw, float expected) {
        NXTLightSensor light = new NXTLightSensor(SensorPort.S1);
        brick.sensor(0).analog().raw(raw, 0);
        assertEquals(expected, fetch(light.getRedMode())[0], 0.0001f);
        assertEquals(expected, fetch(light.getAmbientMode())[0], 0.0001f);
    }

    @Test
    void nxtLightModesSetTheirLamp() {
        NXTLightSensor light = new NXTLightSensor(SensorPort.S1);
        assertTrue(light.isFloodlightOn());
        fetch(light);
        fetch(light.getAmbientMode());
        assertEquals(Color.NONE, light.getFloodlight());
        fetch(light.getMode("Red"));
        assertEquals(Color.RED, light.getFloodlight());
        assertEquals(List.of("expect NXTLightSensor", "type 9", "type 5", "type 6", "type 5"), log());
    }

    @Test
    void otherLampColoursAreRefusedWithoutAnException() {
        NXTLightSensor nxt = new NXTLightSensor(SensorPort.S1);
        RCXLightSensor rcx = new RCXLightSensor(SensorPort.S2);
        for (int color = -1; color <= 13; color++) {
            boolean possible = color == Color.RED || color == Color.NONE;
            assertEquals(possible, nxt.setFloodlight(color), "colour " + color);
            assertEquals(possible, rcx.setFloodlight(color), "colour " + color);
        }
        assertTrue(nxt.isFloodlightOn());
        assertTrue(rcx.isFloodlightOn());
    }

    @Test
    void rcxLightUsesItsOwnTypes() {
        RCXLightSensor light = new RCXLightSensor(SensorPort.S1);
        brick.sensor(0).analog().raw(1000, 0);
        assertEquals(0.7558f, fetch(light.getRedMode())[0], 0.0001f);
        fetch(light.getAmbientMode());
        assertFalse(light.isFloodlightOn());
        assertEquals(Color.NONE, light.getFloodlight());
        assertEquals(List.of("expect RCXLightSensor", "type 9", "type 3", "type 9"), log());
    }

    @Test
    void soundIsWeightedByDefault() {
        NXTSoundSensor sound = new NXTSoundSensor(SensorPort.S1);
        brick.sensor(0).analog().raw(1000, 0);
        assertEquals(0.7558f, fetch(sound)[0], 0.0001f);
        assertEquals(0.7558f, fetch(sound.getDBMode())[0], 0.0001f);
        fetch(sound.getDBAMode());
        assertEquals(List.of("Sound DBA", "Sound DB"), sound.getAvailableModes());
        assertEquals(List.of("expect NXTSoundSensor", "type 9", "type 8", "type 7", "type 8"), log());
    }

    @Test
    void nxtColourDeliversChannelsIdsAndLamps() {
        NXTColorSensor sensor = new NXTColorSensor(SensorPort.S1.open(AnalogPort.class));
        brick.sensor(0).analog().colours(3.3f, 1.65f, 0.33f, 0, 5);
        assertEquals(Color.WHITE, sensor.getFloodlight());
        assertArrayEquals(new float[] {1, 0.5f, 0.1f, 0}, fetch(sensor.getRGBMode()), 1e-6f);
        int[] expected = {-1, 7, 2, 1, 3, 0, 6, -1};
        for (int id = 0; id < expected.length; id++) {
            brick.sensor(0).analog().colours(0, 0, 0, 0, id);
            assertEquals(expected[id], fetch(sensor)[0], "id " + id);
            assertEquals(expected[id], sensor.getColorID());
        }
        brick.sensor(0).analog().colours(0.33f, 0.66f, 0.99f, 1.32f, 0);
        assertEquals(0.1f, fetch(sensor.getRedMode())[0], 1e-6f);
        assertEquals(Color.RED, sensor.getFloodlight());
        assertEquals(0.2f, fetch(sensor.getGreenMode())[0], 1e-6f);
        assertEquals(Color.GREEN, sensor.getFloodlight());
        assertEquals(0.3f, fetch(sensor.getBlueMode())[0], 1e-6f);
        assertEquals(Color.BLUE, sensor.getFloodlight());
        assertEquals(0.4f, fetch(sensor.getAmbientMode())[0], 1e-6f);
        assertFalse(sensor.isFloodlightOn());
        assertFalse(sensor.setFloodlight(Color.YELLOW));
        sensor.setFloodlight(true);
        assertEquals(Color.RED, sensor.getFloodlight());
        sensor.setFloodlight(false);
        assertEquals(List.of("ColorID", "Red", "Green", "Blue", "RGB", "None"), sensor.getAvailableModes());
        assertEquals(List.of("expect NXTColorSensor", "type 13", "type 14", "type 15", "type 16", "type 17", "type 14",
                "type 17"), log());
    }

    private NXTUltrasonicSensor ultrasonic() {
        brick.sensor(0).plug(Wiring.I2C, 123, "nxt-ultrasonic");
        return new NXTUltrasonicSensor(SensorPort.S1);
    }

    @ParameterizedTest
    @CsvSource({"0,0", "40,0.39999998", "100,1", "254,2.54", "255,Infinity"})
    void nxtDistanceIsInMetres(int centimetres, float expected) {
        NXTUltrasonicSensor sensor = ultrasonic();
        brick.sensor(0).i2c().registers(0x42, centimetres);
        assertEquals(expected, fetch(sensor)[0], 1e-6f);
        assertEquals(List.of("expect NXTUltrasonicSensor", "configure 10kHz 9V", "write 41 02", "read 42"), log());
    }

    @Test
    void aPingDeliversEightEchoesAndLeavesTheSensorOff() {
        NXTUltrasonicSensor sensor = ultrasonic();
        brick.sensor(0).i2c().registers(0x42, 10, 20, 30, 40, 50, 60, 255, 255);
        float[] echoes = fetch(sensor.getPingMode());
        assertArrayEquals(new float[] {0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f, INFINITY, INFINITY}, echoes, 1e-6f);
        assertFalse(sensor.isEnabled());
        assertEquals(0.1f, fetch(sensor.getDistanceMode())[0], 1e-6f);
        assertTrue(sensor.isEnabled());
        assertEquals(List.of("write 41 02", "write 41 01", "read 42", "write 41 02", "read 42"), log().subList(2, 7));
    }

    @Test
    void enablingAndDisablingAreCommands() {
        NXTUltrasonicSensor sensor = ultrasonic();
        sensor.disable();
        assertFalse(sensor.isEnabled());
        sensor.enable();
        assertTrue(sensor.isEnabled());
        assertEquals(List.of("write 41 02", "write 41 00", "write 41 02"), log().subList(2, 5));
        assertEquals(List.of("Distance", "Distances"), sensor.getAvailableModes());
    }

    @ParameterizedTest
    @CsvSource({"0,0", "449,0", "450,1", "674,1", "675,2", "910,2", "911,3", "1023,3"})
    void rcxRotationPhasesFollowTheVoltage(int nxtRaw, int phase) {
        RCXRotationSensor sensor = new RCXRotationSensor(SensorPort.S1);
        brick.sensor(0).analog().raw(Math.round(nxtRaw * 4095f / 1023), 0);
        assertEquals(phase, sensor.getPhase());
        sensor.close();
    }

    @Test
    void rcxRotationHasNoModes() {
        RCXRotationSensor sensor = new RCXRotationSensor(SensorPort.S1);
        assertThrows(NullPointerException.class, () -> sensor.getMode(0));
        assertEquals(0, sensor.getTachoCount());
        sensor.close();
    }
}
