/**
 * Finding a way around obstacles: through the corners of a map, over a grid, or at random.
 *
 * <p>May use: the JDK, {@code lejos.robotics}.
 */
package lejos.robotics.pathfinding;
