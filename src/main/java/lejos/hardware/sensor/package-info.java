/**
 * Sensors: base classes for the three ways of wiring (analogue, serial, I²C) and a driver class per sensor.
 *
 * <p>A reading is a sample of floats fetched from a mode. Units are metres, degrees and degrees per second, otherwise
 * shares from 0 to 1; turning left is positive; out of range is positive infinity. A fetch in the mode the device is in
 * returns its latest value and does not block; a fetch in another mode switches the device and blocks until it has
 * data. May use: {@code lejos.*} and the JDK.
 */
package lejos.hardware.sensor;
