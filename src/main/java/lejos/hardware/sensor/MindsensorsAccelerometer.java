package lejos.hardware.sensor;

import lejos.hardware.port.I2CPort;
import lejos.hardware.port.Port;

/**
 * Mindsensors acceleration sensor. Mode "Acceleration": metres per second squared along x, y and z; mode "Tilt":
 * degrees around the axes.
 */
public class MindsensorsAccelerometer extends I2CSensor {
    private static final int TILT = 0x42;
    private static final int ACCELERATION = 0x45;
    private static final int AXES = 3;
    private static final float METRES_PER_SECOND_SQUARED_PER_COUNT = 9.80665e-3f;
    private static final float DEGREES_PER_COUNT = 360f / 256;
    private static final float LEVEL_COUNT_DEGREES = 180;

    private final byte[] registers = new byte[2 * AXES];

    /**
     * A sensor on an open port, which {@link #close()} leaves open.
     *
     * @param address 8-bit address, lowest bit 0
     */
    public MindsensorsAccelerometer(I2CPort port, int address) {
        super(port, address);
        init();
    }

    /** A sensor with the usual address on an open port, which {@link #close()} leaves open. */
    public MindsensorsAccelerometer(I2CPort port) {
        this(port, DEFAULT_I2C_ADDRESS);
    }

    /**
     * A sensor on a port that is opened now and closed with the sensor.
     *
     * @param address 8-bit address, lowest bit 0
     * @throws lejos.hardware.DeviceException if the port is open already
     */
    public MindsensorsAccelerometer(Port port, int address) {
        super(port, address);
        init();
    }

    /**
     * A sensor with the usual address on a port that is opened now and closed with the sensor.
     *
     * @throws lejos.hardware.DeviceException if the port is open already
     */
    public MindsensorsAccelerometer(Port port) {
        this(port, DEFAULT_I2C_ADDRESS);
    }

    /** Sets the modes. */
    protected void init() {
        setModes(new SensorMode[] {new AccelerationMode(), new TiltMode()});
    }

    /** Mode "Acceleration". */
    public SensorMode getAccelerationMode() {
        return getMode(0);
    }

    /** Mode "Tilt". */
    public SensorMode getTiltMode() {
        return getMode(1);
    }

    private final class AccelerationMode implements SensorMode {
        @Override
        public int sampleSize() {
            return AXES;
        }

        /** The device's z axis points down. */
        @Override
        public void fetchSample(float[] sample, int offset) {
            getData(ACCELERATION, registers, registers.length);
            sample[offset] = counts(0) * METRES_PER_SECOND_SQUARED_PER_COUNT;
            sample[offset + 1] = counts(1) * METRES_PER_SECOND_SQUARED_PER_COUNT;
            sample[offset + 2] = -counts(2) * METRES_PER_SECOND_SQUARED_PER_COUNT;
        }

        private int counts(int axis) {
            return (short) (registers[2 * axis] & 0xff | registers[2 * axis + 1] << 8);
        }

        @Override
        public String getName() {
            return "Acceleration";
        }
    }

    private final class TiltMode implements SensorMode {
        @Override
        public int sampleSize() {
            return AXES;
        }

        @Override
        public void fetchSample(float[] sample, int offset) {
            getData(TILT, registers, AXES);
            for (int axis = 0; axis < AXES; axis++) {
                sample[offset + axis] = (registers[axis] & 0xff) * DEGREES_PER_COUNT - LEVEL_COUNT_DEGREES;
            }
        }

        @Override
        public String getName() {
            return "Tilt";
        }
    }
}
