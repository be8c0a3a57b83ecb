package lejos.hardware.sensor;

import lejos.hardware.port.Port;
import lejos.hardware.port.UARTPort;
import lejos.robotics.SampleProvider;

/**
 * The EV3 gyroscope: mode 0 "Rate", mode 1 "Angle", mode 2 "Angle and Rate", all counter-clockwise positive.
 *
 * <p>All modes read the same message of the device, so mixing them costs nothing. Zero reads as −0.0.
 */
public class EV3GyroSensor extends UARTSensor {
    private static final int RATE_ONLY = 1;
    private static final int ANGLE_AND_RATE = 3;
    /** Position of the angle in the message. */
    private static final int ANGLE = 0;
    /** Position of the rate in the message. */
    private static final int RATE = 1;

    /**
     * A sensor on a port that is opened now and closed with the sensor; blocks until it sends data.
     *
     * @throws lejos.hardware.DeviceException if the port is open already
     * @throws IllegalArgumentException if no serial sensor answers
     */
    public EV3GyroSensor(Port port) {
        super(port, ANGLE_AND_RATE);
        initModes();
    }

    /**
     * A sensor on an open port, which {@link #close()} leaves open.
     *
     * @throws lejos.hardware.DeviceException if no serial sensor answers
     */
    public EV3GyroSensor(UARTPort port) {
        super(port, ANGLE_AND_RATE);
        initModes();
    }

    private void initModes() {
        setModes(new SensorMode[] {
            new GyroMode("Rate", RATE), new GyroMode("Angle", ANGLE), new GyroMode("Angle and Rate", ANGLE, RATE)});
    }

    /** Mode "Angle": degrees turned to the left since the start or the last {@link #reset()}, not wrapped at 360. */
    public SampleProvider getAngleMode() {
        return getMode(1);
    }

    /** Mode "Rate": degrees per second, left positive. */
    public SampleProvider getRateMode() {
        return getMode(0);
    }

    /** Mode "Angle and Rate": two elements, the angle first. */
    public SampleProvider getAngleAndRateMode() {
        return getMode(2);
    }

    /**
     * Makes the present angle zero and recalibrates; blocks for two switches of mode. The robot must stand still
     * meanwhile.
     */
    public void reset() {
        switchMode(RATE_ONLY, 0);
        switchMode(ANGLE_AND_RATE, 0);
    }

    /** Some elements of the device's message. */
    private final class GyroMode implements SensorMode {
        private final String name;
        private final int[] elements;

        GyroMode(String name, int... elements) {
            this.name = name;
            this.elements = elements;
        }

        @Override
        public int sampleSize() {
            return elements.length;
        }

        @Override
        public void fetchSample(float[] sample, int offset) {
            switchMode(ANGLE_AND_RATE, 0);
            short[] clockwise = new short[2];
            port.getShorts(clockwise, 0, clockwise.length);
            for (int i = 0; i < elements.length; i++) {
                sample[offset + i] = -(float) clockwise[elements[i]];
            }
        }

        @Override
        public String getName() {
            return name;
        }
    }
}
