package lejos.hardware.sensor;

import lejos.hardware.port.AnalogPort;
import lejos.hardware.port.Port;
import lejos.robotics.SampleProvider;

/**
 * The NXT sound sensor: mode 0 "Sound DBA" weighted like the ear, mode 1 "Sound DB" unweighted; values 0 (quiet) to 1.
 *
 * <p>A fetch waits 10 ms when it has to change the mode.
 */
public class NXTSoundSensor extends AnalogSensor implements SensorConstants {
    /** Wait after a change of mode, milliseconds. */
    protected static final long SWITCH_DELAY = 10;

    /**
     * A sensor on a port that is opened now and closed with the sensor.
     *
     * @throws lejos.hardware.DeviceException if the port is open already
     */
    public NXTSoundSensor(Port port) {
        super(port);
        initModes();
    }

    /** A sensor on an open port, which {@link #close()} leaves open. */
    public NXTSoundSensor(AnalogPort port) {
        super(port);
        initModes();
    }

    private void initModes() {
        setModes(new SensorMode[] {new DBAMode(), new DBMode()});
    }

    /** Mode "Sound DB": all frequencies alike. */
    public SampleProvider getDBMode() {
        return getMode(1);
    }

    /** Mode "Sound DBA": weighted like the ear. */
    public SampleProvider getDBAMode() {
        return getMode(0);
    }

    private void fetchLoudness(int type, float[] sample, int offset) {
        switchType(type, SWITCH_DELAY);
        sample[offset] = 1.0f - normalize(port.getPin1());
    }

    /** Loudness of all frequencies alike. */
    public class DBMode implements SensorMode {
        /** The unweighted mode of the enclosing sensor. */
        public DBMode() {}

        @Override
        public int sampleSize() {
            return 1;
        }

        @Override
        public void fetchSample(float[] sample, int offset) {
            fetchLoudness(TYPE_SOUND_DB, sample, offset);
        }

        @Override
        public String getName() {
            return "Sound DB";
        }
    }

    private final class DBAMode implements SensorMode {
        @Override
        public int sampleSize() {
            return 1;
        }

        @Override
        public void fetchSample(float[] sample, int offset) {
            fetchLoudness(TYPE_SOUND_DBA, sample, offset);
        }

        @Override
        public String getName() {
            return "Sound DBA";
        }
    }
}
