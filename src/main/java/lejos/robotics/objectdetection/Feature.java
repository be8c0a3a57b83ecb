package lejos.robotics.objectdetection;

import lejos.robotics.RangeReading;
import lejos.robotics.RangeReadings;

/** Something a detector found. */
public interface Feature {
    /** Where the nearest object is. */
    RangeReading getRangeReading();

    /** Where all objects are, nearest first. */
    RangeReadings getRangeReadings();

    /** When it was found, in milliseconds. */
    long getTimeStamp();
}
