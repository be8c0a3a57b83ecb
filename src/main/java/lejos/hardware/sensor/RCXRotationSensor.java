package lejos.hardware.sensor;

import lejos.hardware.port.Port;
import lejos.robotics.Tachometer;
import lejos.utility.Delay;

/**
 * The RCX rotation sensor: 16 counts per turn, read from four voltage levels by a background thread. It has no sensor
 * modes.
 *
 * <p>The count and the speed are guarded by the lock of the reader.
 */
public class RCXRotationSensor extends AnalogSensor implements Tachometer, SensorConstants {
    /** Counts per turn. */
    public static final int ONE_ROTATION = 16;
    /** Time between two looks at the voltage, milliseconds. */
    protected static final int UPDATE_TIME = 2;
    /** Change of the count by old and new level. */
    protected static final int[][] inc = {{0, 1, -1, 0}, {-1, 0, 0, 1}, {1, 0, 0, -1}, {0, -1, 1, 0}};

    /** Upper limits of the first three levels, on the NXT's scale of 1023. */
    private static final int[] LEVELS = {450, 675, 911};
    private static final int DEGREES_PER_TURN = 360;
    private static final int MILLIS_PER_SECOND = 1000;

    /** Counts since the last reset, forward positive. */
    protected int count;
    /** The background thread. */
    protected final Reader reader;

    /**
     * A sensor on a port that is opened now and closed with the sensor.
     *
     * @throws lejos.hardware.DeviceException if the port is open already
     */
    public RCXRotationSensor(Port port) {
        super(port, TYPE_ANGLE, MODE_RAW);
        reader = new Reader();
        reader.setDaemon(true);
        reader.setPriority(Thread.MAX_PRIORITY);
        reader.start();
    }

    /** The present voltage level, 0 to 3. */
    protected int getPhase() {
        int raw = NXTRawIntValue(port.getPin1());
        int phase = 0;
        while (phase < LEVELS.length && raw >= LEVELS[phase]) {
            phase++;
        }
        return phase;
    }

    /** Degrees turned since the last reset. */
    @Override
    public int getTachoCount() {
        synchronized (reader) {
            return DEGREES_PER_TURN * count / ONE_ROTATION;
        }
    }

    /** Counts since the last reset, 16 to a turn. */
    public int getRawTachoCount() {
        synchronized (reader) {
            return count;
        }
    }

    @Override
    public void resetTachoCount() {
        synchronized (reader) {
            count = 0;
        }
    }

    /** Speed between the last two counts in degrees per second, without a sign; keeps its value when the axle stops. */
    @Override
    public int getRotationSpeed() {
        synchronized (reader) {
            return reader.degreesPerSecond;
        }
    }

    /** Stops the background thread and frees the port. */
    @Override
    public void close() {
        reader.stopped = true;
        super.close();
    }

    /** Watches the voltage levels; a level counts when it has been read twice in a row. */
    protected class Reader extends Thread {
        private volatile boolean stopped;
        private int degreesPerSecond;
        private int accepted = getPhase();
        private long lastChange = System.currentTimeMillis();

        /** The background thread of the enclosing sensor. */
        protected Reader() {
            super("RCX rotation sensor");
        }

        @Override
        public void run() {
            int previous = accepted;
            while (!stopped) {
                Delay.msDelay(UPDATE_TIME);
                int phase = stopped ? accepted : getPhase();
                if (phase == previous && phase != accepted) {
                    step(inc[accepted][phase]);
                    accepted = phase;
                }
                previous = phase;
            }
        }

        private synchronized void step(int change) {
            count += change;
            long now = System.currentTimeMillis();
            if (change != 0 && now > lastChange) {
                degreesPerSecond = (int) (MILLIS_PER_SECOND * DEGREES_PER_TURN / ONE_ROTATION / (now - lastChange));
            }
            lastChange = now;
        }
    }
}
