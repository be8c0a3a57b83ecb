package lejos.robotics;

/** A sensor of air pressure. */
public interface PressureDetector {
    /** Pressure in kilopascals. */
    float getPressure();
}
