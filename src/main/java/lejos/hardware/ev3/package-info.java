/** The EV3 that a program runs on. May use: {@code brickless.hardware}, the JDK. */
package lejos.hardware.ev3;
