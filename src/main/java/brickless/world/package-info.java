/**
 * Immutable descriptions of an arena and of robots. SI units; the frame is the drawing's: x to the right, y down the
 * page, headings clockwise from +x in radians. May use: the JDK.
 */
package brickless.world;
