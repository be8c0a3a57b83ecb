import lejos.hardware.port.Port;
import lejos.hardware.sensor.I2CSensor;
import lejos.hardware.sensor.SensorMode;

/** A driver for the NXT ultrasonic sensor, which talks through registers on an I2C bus. */
class Ranger extends I2CSensor implements SensorMode {
    private static final int COMMAND = 0x41;
    private static final int FIRST_DISTANCE = 0x42;
    private static final byte CONTINUOUS = 2;

    private final byte[] distance = new byte[1];

    Ranger(Port port) {
        super(port, DEFAULT_I2C_ADDRESS, TYPE_LOWSPEED_9V);
        setModes(new SensorMode[] {this});
        sendData(COMMAND, CONTINUOUS);
    }

    @Override
    public int sampleSize() {
        return 1;
    }

    @Override
    public void fetchSample(float[] sample, int offset) {
        getData(FIRST_DISTANCE, distance, 1);
        int centimetres = distance[0] & 0xff;
        sample[offset] = centimetres == 255 ? Float.POSITIVE_INFINITY : centimetres / 100f;
    }

    @Override
    public String getName() {
        return "Range";
    }
}
