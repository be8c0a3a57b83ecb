package lejos.robotics.filter;

import java.io.FileNotFoundException;
import java.io.IOException;
import java.util.Arrays;
import java.util.Properties;
import java.util.StringJoiner;
import lejos.robotics.Calibrate;
import lejos.robotics.SampleProvider;

/**
 * The base of filters that learn from samples how to correct samples.
 *
 * <p>During calibration each fetch passes a low-pass filter, is added to the statistics and comes out uncorrected.
 * Calibration data can be kept by name; see {@link #store}.
 */
public abstract class AbstractCalibrationFilter extends AbstractFilter implements Calibrate {
    private static final String SAMPLE_SIZE = "sampleSize";
    private static final String TYPE = "type";

    /** Stands before the statistics; without effect unless a time constant is set. */
    protected LowPassFilter lowPassFilter;
    /** Least value of each element during calibration; null before the first. */
    protected float[] min;
    /** Greatest value of each element during calibration; null before the first. */
    protected float[] max;
    /** Sum of each element during calibration; null before the first. */
    protected float[] sum;
    /** Whether calibration is in progress. */
    protected boolean calibrating;
    /** Number of samples in the statistics. */
    protected int numberOfSamplesInCalibration;

    private Properties properties = new Properties();

    /** A filter that does not calibrate yet. */
    public AbstractCalibrationFilter(SampleProvider source) {
        super(source);
        lowPassFilter = new LowPassFilter(source, 0);
    }

    @Override
    public void fetchSample(float[] sample, int offset) {
        if (!calibrating) {
            source.fetchSample(sample, offset);
            return;
        }
        lowPassFilter.fetchSample(sample, offset);
        numberOfSamplesInCalibration++;
        for (int i = 0; i < sampleSize; i++) {
            float value = sample[offset + i];
            min[i] = Math.min(min[i], value);
            max[i] = Math.max(max[i], value);
            sum[i] += value;
        }
    }

    /** Sets the time constant of the low-pass filter in seconds; 0 = no filtering. */
    public void setTimeConstant(float timeConstant) {
        lowPassFilter.setTimeConstant(timeConstant);
    }

    /** Begins calibration with fresh statistics. */
    @Override
    public void startCalibration() {
        lowPassFilter.restart();
        min = new float[sampleSize];
        max = new float[sampleSize];
        sum = new float[sampleSize];
        Arrays.fill(min, Float.MAX_VALUE);
        Arrays.fill(max, -Float.MAX_VALUE);
        numberOfSamplesInCalibration = 0;
        calibrating = true;
    }

    @Override
    public void stopCalibration() {
        calibrating = false;
    }

    /** Interrupts calibration and keeps the statistics. */
    public void suspendCalibration() {
        calibrating = false;
    }

    /** Goes on with calibration after {@link #suspendCalibration}. */
    public void resumeCalibration() {
        calibrating = true;
    }

    /**
     * Reads calibration data kept by {@link #store}.
     *
     * @throws FileNotFoundException if there are none of that name
     * @throws CalibrationFileException if they are of another kind of filter or another size of sample
     */
    protected void load(String filename) throws FileNotFoundException, IOException {
        properties = CalibrationFiles.read(filename);
        int size = Integer.parseInt(properties.getProperty(SAMPLE_SIZE).strip());
        if (size != sampleSize) {
            throw new CalibrationFileException("calibration of " + size + " elements for a source of " + sampleSize);
        }
        String type = properties.getProperty(TYPE);
        if (!type.equals(toString())) {
            throw new CalibrationFileException("calibration of a " + type + " for a " + this);
        }
    }

    /**
     * Keeps the calibration data under a name, until the brick forgets: as long as the simulated brick exists.
     *
     * @param filename name without folder and extension
     */
    protected void store(String filename) {
        properties.setProperty(SAMPLE_SIZE, Integer.toString(sampleSize));
        properties.setProperty(TYPE, toString());
        CalibrationFiles.write(filename, properties);
    }

    /** Array of calibration data. */
    protected float[] getPropertyArray(String key) {
        String[] words = properties.getProperty(key).strip().split("\\s+");
        float[] values = new float[words.length];
        for (int i = 0; i < words.length; i++) {
            values[i] = Float.parseFloat(words[i]);
        }
        return values;
    }

    /** Sets an array of calibration data. */
    protected void setPropertyArray(String key, float[] values) {
        StringJoiner text = new StringJoiner(" ");
        for (float value : values) {
            text.add(Float.toString(value));
        }
        properties.setProperty(key, text.toString());
    }

    /** Sets a number of calibration data. */
    protected void setProperty(String key, float value) {
        properties.setProperty(key, Float.toString(value));
    }

    /** Number of calibration data. */
    protected float getProperty(String key) {
        return Float.parseFloat(properties.getProperty(key));
    }

    /** Calibration data do not fit the filter. */
    public class CalibrationFileException extends RuntimeException {
        private static final long serialVersionUID = 1L;

        /** With a message. */
        public CalibrationFileException(String message) {
            super(message);
        }
    }
}
