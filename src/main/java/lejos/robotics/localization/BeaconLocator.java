package lejos.robotics.localization;

import java.util.ArrayList;

/** Something that sees beacons. */
public interface BeaconLocator {
    /** Bearings of the beacons seen, in degrees counter-clockwise from the robot's heading, 0 to 360. */
    ArrayList<Double> locate();
}
