/**
 * Watching for objects: detectors that scan again and again and tell listeners what they find.
 *
 * <p>May use: the JDK, {@code lejos.robotics}, {@code lejos.utility}.
 */
package lejos.robotics.objectdetection;
