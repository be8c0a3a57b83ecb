package programs.fitted.owndrivers;

import lejos.hardware.port.Port;
import lejos.hardware.sensor.I2CSensor;

/** The NXT distance sensor by its registers. */
class RangeRegisters extends I2CSensor {
    private final byte[] distance = new byte[1];

    RangeRegisters(Port port) {
        super(port, DEFAULT_I2C_ADDRESS, TYPE_LOWSPEED_9V);
        sendData(0x41, (byte) 2);
    }

    int centimetres() {
        getData(0x42, distance, 1);
        return distance[0] & 0xff;
    }
}
