/**
 * Chassis: how the wheels of a robot work together, so that motions of the whole robot become motions of its motors.
 *
 * <p>x is forward, y to the left, angles are in degrees counter-clockwise. The unit of distance is the one in which the
 * wheels are described. May use: the JDK, {@code lejos.robotics}, {@code lejos.utility}.
 */
package lejos.robotics.chassis;
