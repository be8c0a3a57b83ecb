package lejos.hardware.sensor;

/**
 * Sensor type, mode and colour numbers of the NXT generation, as ports and drivers take them. The colours are LEGO's
 * own numbers, not those of {@link lejos.robotics.Color}.
 */
public interface SensorConstants {
    /** LEGO colour id of black. */
    int BLACK = 1;
    /** LEGO colour id of blue. */
    int BLUE = 2;
    /** LEGO colour id of green. */
    int GREEN = 3;
    /** LEGO colour id of yellow. */
    int YELLOW = 4;
    /** LEGO colour id of red. */
    int RED = 5;
    /** LEGO colour id of white. */
    int WHITE = 6;
    /** LEGO colour id of brown. */
    int BROWN = 7;
    /** Position of the red channel in a reading of an NXT colour sensor. */
    int RED_INDEX = 0;
    /** Position of the green channel. */
    int GREEN_INDEX = 1;
    /** Position of the blue channel. */
    int BLUE_INDEX = 2;
    /** Position of the background channel (lamps off). */
    int BLANK_INDEX = 3;
    /** Nothing plugged in. */
    int TYPE_NO_SENSOR = 0;
    /** NXT touch sensor. */
    int TYPE_SWITCH = 1;
    /** RCX temperature sensor. */
    int TYPE_TEMPERATURE = 2;
    /** RCX light sensor. */
    int TYPE_REFLECTION = 3;
    /** RCX rotation sensor. */
    int TYPE_ANGLE = 4;
    /** NXT light sensor, lamp on. */
    int TYPE_LIGHT_ACTIVE = 5;
    /** NXT light sensor, lamp off. */
    int TYPE_LIGHT_INACTIVE = 6;
    /** NXT sound sensor, all frequencies. */
    int TYPE_SOUND_DB = 7;
    /** NXT sound sensor, weighted like the ear. */
    int TYPE_SOUND_DBA = 8;
    /** Plain analogue device. */
    int TYPE_CUSTOM = 9;
    /** I²C at 10 kHz. */
    int TYPE_LOWSPEED = 10;
    /** I²C at 10 kHz with 9 V on pin 1. */
    int TYPE_LOWSPEED_9V = 11;
    /** RS-485, not available on an EV3. */
    int TYPE_HISPEED = 12;
    /** NXT colour sensor, all lamps in turn. */
    int TYPE_COLORFULL = 13;
    /** NXT colour sensor, red lamp. */
    int TYPE_COLORRED = 14;
    /** NXT colour sensor, green lamp. */
    int TYPE_COLORGREEN = 15;
    /** NXT colour sensor, blue lamp. */
    int TYPE_COLORBLUE = 16;
    /** NXT colour sensor, lamps off. */
    int TYPE_COLORNONE = 17;
    /** I²C at 100 kHz. */
    int TYPE_HIGHSPEED = 18;
    /** I²C at 100 kHz with 9 V on pin 1. */
    int TYPE_HIGHSPEED_9V = 19;
    /** Smallest type. */
    int MIN_TYPE = 0;
    /** Largest type. */
    int MAX_TYPE = 19;
    /** Unprocessed values. */
    int MODE_RAW = 0;
    /** Largest value of an NXT's converter. */
    int NXT_ADC_RES = 1023;
}
