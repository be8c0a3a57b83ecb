package lejos.hardware.sensor;

import lejos.hardware.port.I2CPort;
import lejos.hardware.port.Port;
import lejos.robotics.SampleProvider;
import lejos.utility.Delay;

/**
 * The NXT ultrasonic sensor: mode 0 "Distance" in metres, mode 1 "Distances" with up to eight echoes of one ping.
 *
 * <p>The sensor needs 5 ms between commands and 30 ms between measurements; calls that come earlier block for the rest.
 */
public class NXTUltrasonicSensor extends I2CSensor {
    /** Command: do not measure. */
    protected static final byte MODE_OFF = 0x0;
    /** Command: measure once. */
    protected static final byte MODE_PING = 0x1;
    /** Command: measure all the time. */
    protected static final byte MODE_CONTINUOUS = 0x2;

    private static final int REG_MODE = 0x41;
    private static final int REG_DISTANCE = 0x42;
    private static final int ECHOES = 8;
    private static final int NO_ECHO = 255;
    private static final float METRES_PER_CENTIMETRE = 0.01f;
    private static final int COMMAND_MILLIS = 5;
    private static final int MEASUREMENT_MILLIS = 30;
    /** Longest way there and back, and the sensor's own time. */
    private static final int PING_MILLIS = 50;

    private byte mode = MODE_OFF;
    private long nextCommand;
    private long nextMeasurement;

    /**
     * A sensor on an open port, which {@link #close()} leaves open.
     *
     * @throws lejos.hardware.port.I2CException if the sensor does not answer
     */
    public NXTUltrasonicSensor(I2CPort port) {
        super(port);
        port.setType(TYPE_LOWSPEED_9V);
        init();
    }

    /**
     * A sensor on a port that is opened now and closed with the sensor.
     *
     * @throws lejos.hardware.DeviceException if the port is open already
     * @throws lejos.hardware.port.I2CException if the sensor does not answer; the port stays open
     */
    public NXTUltrasonicSensor(Port port) {
        super(port, DEFAULT_I2C_ADDRESS, TYPE_LOWSPEED_9V);
        init();
    }

    private void init() {
        setModes(new SensorMode[] {new DistanceMode(), new PingMode()});
        setMode(MODE_CONTINUOUS);
    }

    @Override
    public synchronized void getData(int register, byte[] buf, int off, int len) {
        awaitCommandTime();
        super.getData(register, buf, off, len);
        nextCommand = System.currentTimeMillis() + COMMAND_MILLIS;
    }

    @Override
    public synchronized void sendData(int register, byte[] buf, int off, int len) {
        awaitCommandTime();
        super.sendData(register, buf, off, len);
        nextCommand = System.currentTimeMillis() + COMMAND_MILLIS;
    }

    private void awaitCommandTime() {
        Delay.msDelay(nextCommand - System.currentTimeMillis());
    }

    /** Mode "Distance": metres to the nearest object, positive infinity if there is no echo. */
    public SampleProvider getDistanceMode() {
        return getMode(0);
    }

    /** Mode "Distances": metres of up to eight echoes of one ping, the rest positive infinity. */
    public SampleProvider getPingMode() {
        return getMode(1);
    }

    /** Starts measuring all the time. */
    public void enable() {
        setMode(MODE_CONTINUOUS);
    }

    /** Stops measuring until the next {@link #enable()} or fetch. */
    public void disable() {
        setMode(MODE_OFF);
    }

    /** Whether the sensor measures all the time; a ping leaves it off. */
    public boolean isEnabled() {
        return mode != MODE_OFF;
    }

    /**
     * Gives the sensor a command.
     *
     * @return true
     * @throws lejos.hardware.port.I2CException if the sensor does not answer
     */
    protected boolean setMode(byte mode) {
        sendData(REG_MODE, mode);
        this.mode = mode;
        nextMeasurement = System.currentTimeMillis() + MEASUREMENT_MILLIS;
        return true;
    }

    private static float metres(byte centimetres) {
        int distance = centimetres & 0xff;
        return distance == NO_ECHO ? Float.POSITIVE_INFINITY : distance * METRES_PER_CENTIMETRE;
    }

    /** The nearest echo, measured all the time. */
    public class DistanceMode implements SensorMode {
        private final byte[] reading = new byte[1];

        /** The distance mode of the enclosing sensor. */
        public DistanceMode() {}

        @Override
        public int sampleSize() {
            return 1;
        }

        @Override
        public void fetchSample(float[] sample, int offset) {
            if (mode != MODE_CONTINUOUS) {
                setMode(MODE_CONTINUOUS);
            }
            Delay.msDelay(nextMeasurement - System.currentTimeMillis());
            getData(REG_DISTANCE, reading, reading.length);
            nextMeasurement = System.currentTimeMillis() + MEASUREMENT_MILLIS;
            sample[offset] = metres(reading[0]);
        }

        @Override
        public String getName() {
            return "Distance";
        }
    }

    /** All echoes of one ping. */
    public class PingMode implements SensorMode {
        private final byte[] reading = new byte[ECHOES];

        /** The ping mode of the enclosing sensor. */
        public PingMode() {}

        @Override
        public int sampleSize() {
            return ECHOES;
        }

        @Override
        public void fetchSample(float[] sample, int offset) {
            setMode(MODE_PING);
            Delay.msDelay(PING_MILLIS);
            getData(REG_DISTANCE, reading, reading.length);
            mode = MODE_OFF;
            for (int i = 0; i < ECHOES; i++) {
                sample[offset + i] = metres(reading[i]);
            }
        }

        @Override
        public String getName() {
            return "Distances";
        }
    }
}
