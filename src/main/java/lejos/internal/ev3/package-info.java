/**
 * What stands behind the ports of {@code lejos.hardware.port}: open state, sensor and motor ports, the default motor
 * regulator.
 *
 * <p>May use: {@code lejos.*}, {@code brickless.hardware} and the JDK.
 */
package lejos.internal.ev3;
