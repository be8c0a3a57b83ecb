/**
 * The EV3 that a program runs on. May use: {@code lejos.hardware}, {@code lejos.internal.ev3},
 * {@code brickless.hardware}, the JDK.
 */
package lejos.hardware.ev3;
