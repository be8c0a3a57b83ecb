package lejos.hardware.port;

import lejos.hardware.BrickFinder;

/** The four motor ports of the default brick; touching them opens nothing. */
public interface MotorPort {
    /** Port A. */
    Port A = BrickFinder.getDefault().getPort("A");
    /** Port B. */
    Port B = BrickFinder.getDefault().getPort("B");
    /** Port C. */
    Port C = BrickFinder.getDefault().getPort("C");
    /** Port D. */
    Port D = BrickFinder.getDefault().getPort("D");
}
