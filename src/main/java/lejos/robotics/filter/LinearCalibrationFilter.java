package lejos.robotics.filter;

import java.io.IOException;
import java.util.Arrays;
import lejos.robotics.SampleProvider;

/**
 * Corrects offset and scale, so that the least and greatest values of a calibration become given values.
 *
 * <p>To correct the offset alone, calibrate at rest or all around; to correct both, move the sensor through its whole
 * range.
 */
public class LinearCalibrationFilter extends AbstractCalibrationFilter {
    /** Corrects the offset. */
    public static final int OFFSET_CALIBRATION = 0;
    /** Corrects offset and scale. */
    public static final int OFFSET_AND_SCALE_CALIBRATION = 1;

    private static final String OFFSET = "offset";
    private static final String SCALE = "scale";
    private static final String CALIBRATION_TYPE = "calibrationType";

    private final float[] lower;
    private final float[] upper;
    private float[] offset;
    private float[] scale;
    private int calibrationType = OFFSET_CALIBRATION;

    /** A filter with calibration data kept by {@link #save}; without effect if there are none. */
    public LinearCalibrationFilter(SampleProvider source, String filename) {
        this(source);
        open(filename);
    }

    /** A filter without effect until calibrated. */
    public LinearCalibrationFilter(SampleProvider source) {
        super(source);
        lower = new float[sampleSize];
        upper = new float[sampleSize];
        resetCorrection();
    }

    /** Name of this kind of filter in calibration data. */
    @Override
    public String toString() {
        return "LinearCalibrationFilter";
    }

    /** Makes the range of all elements −range to range. */
    public void setScaleCalibration(float range) {
        setScaleCalibration(-range, range);
    }

    /** Makes the range of all elements lowest to highest. */
    public void setScaleCalibration(float lowest, float highest) {
        Arrays.fill(lower, lowest);
        Arrays.fill(upper, highest);
    }

    /** Makes the range of each element lowest to highest. */
    public void setScaleCalibration(float[] lowest, float[] highest) {
        System.arraycopy(lowest, 0, lower, 0, sampleSize);
        System.arraycopy(highest, 0, upper, 0, sampleSize);
    }

    /** Makes the middle of all elements a value. */
    public void setOffsetCalibration(float middle) {
        setScaleCalibration(middle, middle);
    }

    /** Makes the middle of each element a value. */
    public void setOffsetCalibration(float[] middle) {
        setScaleCalibration(middle, middle);
    }

    /**
     * Chooses what to correct.
     *
     * @throws IllegalArgumentException if the type is neither of the two constants
     */
    public void setCalibrationType(int calibrationType) {
        if (calibrationType != OFFSET_CALIBRATION && calibrationType != OFFSET_AND_SCALE_CALIBRATION) {
            throw new IllegalArgumentException("calibration type " + calibrationType);
        }
        this.calibrationType = calibrationType;
    }

    /** As {@link #getCalibrationType}. */
    public int getCallibrationType() {
        return getCalibrationType();
    }

    /** What to correct. */
    public int getCalibrationType() {
        return calibrationType;
    }

    /** What is subtracted from each element, as a copy. */
    public float[] getOffsetCorrection() {
        return offset.clone();
    }

    /** What each element is then divided by if scale is corrected, as a copy. */
    public float[] getScaleCorrection() {
        return scale.clone();
    }

    @Override
    public void startCalibration() {
        resetCorrection();
        super.startCalibration();
    }

    @Override
    public void stopCalibration() {
        super.stopCalibration();
    }

    /** Keeps the correction under a name; see {@link #store}. */
    public void save(String filename) {
        setPropertyArray(OFFSET, offset);
        setPropertyArray(SCALE, scale);
        setProperty(CALIBRATION_TYPE, calibrationType);
        store(filename);
    }

    /** Takes over a correction kept under a name; if there is none that fits, prints why and corrects nothing. */
    public void open(String filename) {
        try {
            load(filename);
            offset = getPropertyArray(OFFSET);
            scale = getPropertyArray(SCALE);
            calibrationType = (int) getProperty(CALIBRATION_TYPE);
        } catch (IOException | RuntimeException e) {
            System.out.println("No calibration: " + e.getMessage());
            resetCorrection();
        }
    }

    @Override
    public void fetchSample(float[] sample, int off) {
        super.fetchSample(sample, off);
        if (calibrating) {
            updateCorrection();
            return;
        }
        for (int i = 0; i < sampleSize; i++) {
            sample[off + i] -= offset[i];
            if (calibrationType == OFFSET_AND_SCALE_CALIBRATION) {
                sample[off + i] /= scale[i];
            }
        }
    }

    private void updateCorrection() {
        for (int i = 0; i < sampleSize; i++) {
            if (upper[i] != lower[i]) {
                scale[i] = (max[i] - min[i]) / (upper[i] - lower[i]);
            }
            offset[i] = (max[i] + min[i]) / 2 - (upper[i] + lower[i]) / 2;
        }
    }

    private void resetCorrection() {
        offset = new float[sampleSize];
        scale = new float[sampleSize];
        Arrays.fill(scale, 1);
    }
}
