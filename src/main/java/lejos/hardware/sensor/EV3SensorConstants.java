package lejos.hardware.sensor;

/** Numbers of the EV3's port drivers: connections, device types, pin commands, converter. */
public interface EV3SensorConstants {
    /** Number of input ports. */
    int PORTS = 4;
    /** Number of output ports. */
    int MOTORS = 4;
    /** Connection not known yet. */
    int CONN_UNKNOWN = 111;
    /** Daisy-chained brick. */
    int CONN_DAISYCHAIN = 117;
    /** NXT colour sensor. */
    int CONN_NXT_COLOR = 118;
    /** NXT analogue sensor. */
    int CONN_NXT_DUMB = 119;
    /** I²C sensor. */
    int CONN_NXT_IIC = 120;
    /** EV3 analogue sensor. */
    int CONN_INPUT_DUMB = 121;
    /** EV3 serial sensor. */
    int CONN_INPUT_UART = 122;
    /** Output without an encoder. */
    int CONN_OUTPUT_DUMB = 123;
    /** Output with its own protocol. */
    int CONN_OUTPUT_INTELLIGENT = 124;
    /** Motor with an encoder. */
    int CONN_OUTPUT_TACHO = 125;
    /** Empty port. */
    int CONN_NONE = 126;
    /** Impossible reading of the pins. */
    int CONN_ERROR = 127;
    /** NXT touch sensor. */
    int TYPE_NXT_TOUCH = 1;
    /** NXT light sensor. */
    int TYPE_NXT_LIGHT = 2;
    /** NXT sound sensor. */
    int TYPE_NXT_SOUND = 3;
    /** NXT colour sensor. */
    int TYPE_NXT_COLOR = 4;
    /** Large motor. */
    int TYPE_TACHO = 7;
    /** Medium motor. */
    int TYPE_MINITACHO = 8;
    /** Other motor with an encoder. */
    int TYPE_NEWTACHO = 9;
    /** First number for other makers. */
    int TYPE_THIRD_PARTY_START = 50;
    /** Last number for other makers. */
    int TYPE_THIRD_PARTY_END = 99;
    /** I²C device not identified. */
    int TYPE_IIC_UNKNOWN = 100;
    /** Test device. */
    int TYPE_NXT_TEST = 101;
    /** I²C sensor. */
    int TYPE_NXT_IIC = 123;
    /** Terminal. */
    int TYPE_TERMINAL = 124;
    /** Not identified yet. */
    int TYPE_UNKNOWN = 125;
    /** Empty port. */
    int TYPE_NONE = 126;
    /** Identification failed. */
    int TYPE_ERROR = 127;
    /** Most modes of a serial sensor. */
    int UART_MAX_MODES = 8;
    /** Longest message, bytes. */
    int MAX_DEVICE_DATALENGTH = 32;
    /** Longest I²C message, bytes. */
    int IIC_DATA_LENGTH = 32;
    /** Done. */
    int STATUS_OK = 0;
    /** Not ready. */
    int STATUS_BUSY = 1;
    /** Failed. */
    int STATUS_FAIL = 2;
    /** Stopped. */
    int STATUS_STOP = 4;
    /** Pins: no change. */
    byte CMD_NONE = 45;
    /** Pins: floating. */
    byte CMD_FLOAT = 102;
    /** Pins: set those added ({@link #CMD_PIN1}, {@link #CMD_PIN5}). */
    byte CMD_SET = 48;
    /** Pins: identify the device. */
    byte CMD_AUTOMATIC = 97;
    /** Pins: connected. */
    byte CMD_CONNECTED = 99;
    /** Pins: disconnected. */
    byte CMD_DISCONNECTED = 100;
    /** NXT colour sensor: all lamps. */
    byte CMD_COL_COL = 13;
    /** NXT colour sensor: red. */
    byte CMD_COL_RED = 14;
    /** NXT colour sensor: green. */
    byte CMD_COL_GRN = 15;
    /** NXT colour sensor: blue. */
    byte CMD_COL_BLU = 17;
    /** NXT colour sensor: lamps off. */
    byte CMD_COL_AMB = 18;
    /** Pin 1 in {@link #CMD_SET}. */
    byte CMD_PIN1 = 1;
    /** Pin 5 in {@link #CMD_SET}. */
    byte CMD_PIN5 = 2;
    /** Reference of the converter, volts. */
    float ADC_REF = 5.0f;
    /** Largest value of the converter. */
    int ADC_RES = 4095;
}
