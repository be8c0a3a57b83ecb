/** The battery model. May use: {@code brickless.hardware}, {@code brickless.kernel}. */
package brickless.device.battery;
