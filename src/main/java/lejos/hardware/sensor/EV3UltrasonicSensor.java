package lejos.hardware.sensor;

import lejos.hardware.port.Port;
import lejos.hardware.port.UARTPort;
import lejos.robotics.SampleProvider;

/** The EV3 ultrasonic sensor. Mode 0 "Distance" in metres, mode 1 "Listen" for other ultrasonic sensors. */
public class EV3UltrasonicSensor extends UARTSensor {
    private static final int DISTANCE = 0;
    private static final int LISTEN = 2;
    private static final int SINGLE_SHOT = 3;
    /** Reading in millimetres when there is no echo. */
    private static final int NO_ECHO = 2550;
    private static final float METRES_PER_MILLIMETRE = 0.001f;

    /**
     * A sensor on a port that is opened now and closed with the sensor; blocks until it sends data.
     *
     * @throws lejos.hardware.DeviceException if the port is open already
     * @throws IllegalArgumentException if no serial sensor answers
     */
    public EV3UltrasonicSensor(Port port) {
        super(port, DISTANCE);
        init();
    }

    /**
     * A sensor on an open port, which {@link #close()} leaves open.
     *
     * @throws lejos.hardware.DeviceException if no serial sensor answers
     */
    public EV3UltrasonicSensor(UARTPort port) {
        super(port, DISTANCE);
        init();
    }

    /** Sets the modes. */
    protected void init() {
        setModes(new SensorMode[] {new DistanceMode(), new ListenMode()});
    }

    /** Mode "Listen": 1 if another ultrasonic source is heard, else 0. */
    public SampleProvider getListenMode() {
        return getMode(1);
    }

    /** Mode "Distance": metres to the nearest object in the beam, positive infinity if there is no echo. */
    public SampleProvider getDistanceMode() {
        return getMode(0);
    }

    /** Starts measuring and lights the LEDs; blocks for the switch. */
    public void enable() {
        switchMode(DISTANCE, 0);
    }

    /** Stops measuring and darkens the LEDs until the next {@link #enable()} or fetch. */
    public void disable() {
        switchMode(SINGLE_SHOT, 0);
    }

    /** Whether the sensor measures. */
    public boolean isEnabled() {
        return currentMode != SINGLE_SHOT;
    }

    private final class DistanceMode implements SensorMode {
        @Override
        public int sampleSize() {
            return 1;
        }

        @Override
        public void fetchSample(float[] sample, int offset) {
            switchMode(DISTANCE, 0);
            int millimetres = port.getShort();
            sample[offset] = millimetres == NO_ECHO ? Float.POSITIVE_INFINITY : millimetres * METRES_PER_MILLIMETRE;
        }

        @Override
        public String getName() {
            return "Distance";
        }
    }

    private final class ListenMode implements SensorMode {
        @Override
        public int sampleSize() {
            return 1;
        }

        @Override
        public void fetchSample(float[] sample, int offset) {
            switchMode(LISTEN, 0);
            sample[offset] = port.getByte() & 0xff;
        }

        @Override
        public String getName() {
            return "Listen";
        }
    }
}
