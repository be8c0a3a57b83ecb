/**
 * Maps of lines and grids, readers for them, and the navigation model that brick and PC keep in step.
 *
 * <p>May use: the JDK, {@code lejos.robotics}, {@code lejos.hardware}, {@code lejos.remote.nxt},
 * {@code lejos.utility}.
 */
package lejos.robotics.mapping;
