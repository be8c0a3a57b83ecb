/**
 * Text and graphics on the brick's screen. May use: {@code lejos.hardware}, {@code lejos.internal.ev3},
 * {@code brickless.hardware}, the JDK.
 */
package lejos.hardware.lcd;
