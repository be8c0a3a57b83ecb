/**
 * Maps of lines and grids, and readers for them.
 *
 * <p>May use: the JDK, {@code lejos.robotics}.
 */
package lejos.robotics.mapping;
