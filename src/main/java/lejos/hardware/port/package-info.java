/**
 * The ports of a brick and what can be done with an opened one: interfaces only, implemented in {@code
 * lejos.internal.ev3}.
 *
 * <p>May use: {@code lejos.*} and the JDK.
 */
package lejos.hardware.port;
