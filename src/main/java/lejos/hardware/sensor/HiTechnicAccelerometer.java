package lejos.hardware.sensor;

import lejos.hardware.port.I2CPort;
import lejos.hardware.port.Port;

/**
 * HiTechnic acceleration and tilt sensor. Mode "Acceleration": metres per second squared along x, y and z, within ±2 g.
 */
public class HiTechnicAccelerometer extends I2CSensor {
    /** First of the three upper bytes; the three lower bytes follow. */
    private static final int ACCELERATION = 0x42;
    private static final int AXES = 3;
    private static final int LOWER_BITS = 2;
    private static final float METRES_PER_SECOND_SQUARED_PER_COUNT = 9.80665f / 200;

    private final byte[] registers = new byte[2 * AXES];

    /**
     * A sensor on an open port, which {@link #close()} leaves open.
     *
     * @param address 8-bit address, lowest bit 0
     */
    public HiTechnicAccelerometer(I2CPort port, int address) {
        super(port, address);
        init();
    }

    /** A sensor with the usual address on an open port, which {@link #close()} leaves open. */
    public HiTechnicAccelerometer(I2CPort port) {
        this(port, DEFAULT_I2C_ADDRESS);
    }

    /**
     * A sensor on a port that is opened now and closed with the sensor.
     *
     * @param address 8-bit address, lowest bit 0
     * @throws lejos.hardware.DeviceException if the port is open already
     */
    public HiTechnicAccelerometer(Port port, int address) {
        super(port, address);
        init();
    }

    /**
     * A sensor with the usual address on a port that is opened now and closed with the sensor.
     *
     * @throws lejos.hardware.DeviceException if the port is open already
     */
    public HiTechnicAccelerometer(Port port) {
        this(port, DEFAULT_I2C_ADDRESS);
    }

    /** Sets the modes. */
    protected void init() {
        setModes(new SensorMode[] {new AccelerationMode()});
    }

    /** Mode "Acceleration". */
    public SensorMode getAccelerationMode() {
        return getMode(0);
    }

    private final class AccelerationMode implements SensorMode {
        @Override
        public int sampleSize() {
            return AXES;
        }

        @Override
        public void fetchSample(float[] sample, int offset) {
            getData(ACCELERATION, registers, registers.length);
            for (int axis = 0; axis < AXES; axis++) {
                int counts = (registers[axis] << LOWER_BITS) + (registers[AXES + axis] & 0xff);
                sample[offset + axis] = counts * METRES_PER_SECOND_SQUARED_PER_COUNT;
            }
        }

        @Override
        public String getName() {
            return "Acceleration";
        }
    }
}
