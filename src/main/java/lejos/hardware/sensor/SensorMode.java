package lejos.hardware.sensor;

import lejos.robotics.SampleProvider;

/** One way of measuring with a sensor. */
public interface SensorMode extends SampleProvider {
    /** Name of the mode, e.g. {@code "Distance"}. */
    String getName();
}
