package lejos.robotics.chassis;

import lejos.robotics.RegulatedMotor;
import lejos.utility.Matrix;

/** A driven wheel of a chassis. */
public interface Wheel {
    /** One row: degrees the motor turns per unit forward, per unit to the left, and per degree the robot turns. */
    Matrix getFactors();

    /** The motor that drives the wheel. */
    RegulatedMotor getMotor();
}
