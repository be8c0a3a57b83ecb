/**
 * Points, lines and rectangles in the plane, in the manner of {@code java.awt.geom}, which a brick has not.
 *
 * <p>Coordinates are in whatever unit the program likes, y usually up. May use: the JDK.
 */
package lejos.robotics.geometry;
