package lejos.hardware.port;

import lejos.hardware.BrickFinder;

/** The four sensor ports of the default brick; touching them opens nothing. */
public interface SensorPort {
    /** Port S1. */
    Port S1 = BrickFinder.getDefault().getPort("S1");
    /** Port S2. */
    Port S2 = BrickFinder.getDefault().getPort("S2");
    /** Port S3. */
    Port S3 = BrickFinder.getDefault().getPort("S3");
    /** Port S4. */
    Port S4 = BrickFinder.getDefault().getPort("S4");
}
