package lejos.hardware.motor;

import lejos.hardware.port.MotorPort;

/**
 * Four ready-made regulated motors.
 *
 * <p>Touching any of them opens <em>all four</em> ports; a program that uses this class cannot create motor objects of
 * its own, and this class cannot be initialised while one of the ports is open.
 */
public class Motor {
    /** Motor on port A. */
    public static final NXTRegulatedMotor A = new NXTRegulatedMotor(MotorPort.A);
    /** Motor on port B. */
    public static final NXTRegulatedMotor B = new NXTRegulatedMotor(MotorPort.B);
    /** Motor on port C. */
    public static final NXTRegulatedMotor C = new NXTRegulatedMotor(MotorPort.C);
    /** Motor on port D. */
    public static final NXTRegulatedMotor D = new NXTRegulatedMotor(MotorPort.D);

    private Motor() {}
}
