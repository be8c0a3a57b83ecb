/**
 * The brick as a whole: finding it, keys, LEDs, sound, battery, Bluetooth and WiFi. May use:
 * {@code brickless.hardware}, the JDK.
 */
package lejos.hardware;
