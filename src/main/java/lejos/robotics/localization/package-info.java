/**
 * Where am I: pose providers that count moves, use compasses and beacons, or compare range readings with a map.
 *
 * <p>May use: the JDK, {@code lejos.robotics}, {@code lejos.hardware} for a buzz.
 */
package lejos.robotics.localization;
