/**
 * Driving: poses, moves, pilots that drive them and a navigator that drives along paths.
 *
 * <p>x is forward at heading 0, y to the left, headings are in degrees counter-clockwise. The unit of distance is the
 * program's. May use: the JDK, {@code lejos.robotics}, {@code lejos.hardware}, {@code lejos.utility}.
 */
package lejos.robotics.navigation;
