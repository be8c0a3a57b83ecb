/**
 * The brick as a whole: finding it, keys, LEDs, sound, battery, Bluetooth and WiFi. May use:
 * {@code lejos.*}, {@code brickless.hardware}, the JDK.
 */
package lejos.hardware;
