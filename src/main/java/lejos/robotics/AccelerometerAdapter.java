package lejos.robotics;

import lejos.robotics.filter.AbstractFilter;

/** An acceleration mode as an {@link Accelerometer}; values lose their fractions. */
public class AccelerometerAdapter extends AbstractFilter implements Accelerometer {
    private final float[] sample;

    /** An adapter; the source's elements are x, y and z. */
    public AccelerometerAdapter(SampleProvider source) {
        super(source);
        sample = new float[sampleSize];
    }

    /** Takes a sample and returns one element of it. */
    protected int getElement(int index) {
        fetchSample(sample, 0);
        return (int) sample[index];
    }

    @Override
    public int getXAccel() {
        return getElement(0);
    }

    @Override
    public int getYAccel() {
        return getElement(1);
    }

    @Override
    public int getZAccel() {
        return getElement(2);
    }
}
