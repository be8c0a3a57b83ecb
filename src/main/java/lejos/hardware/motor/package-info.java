/**
 * Motors: regulated (speed, angle, hold), unregulated (plain power), and the regulator contract between a motor and its
 * port.
 *
 * <p>May use: {@code lejos.*}, {@code brickless.hardware} and the JDK.
 */
package lejos.hardware.motor;
