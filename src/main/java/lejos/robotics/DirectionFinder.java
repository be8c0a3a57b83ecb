package lejos.robotics;

/** A compass, or something as good as one. */
public interface DirectionFinder extends Calibrate {
    /** Heading in degrees, 0 to 360, counter-clockwise from the zero direction. */
    float getDegreesCartesian();

    /** Makes the present heading the zero direction. */
    void resetCartesianZero();
}
