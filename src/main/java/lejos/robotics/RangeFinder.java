package lejos.robotics;

/** A sensor that measures distance to what lies ahead. */
public interface RangeFinder {
    /** Distance to the nearest object, in the unit of the implementation (centimetres by custom). */
    float getRange();

    /** Distances to all objects seen, nearest first. */
    float[] getRanges();
}
