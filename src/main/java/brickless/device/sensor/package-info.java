/**
 * Sensors: the input ports that programs use and one model per device, which turns the arena's state into what the
 * device would send.
 *
 * <p>May use: {@code brickless.hardware}, {@code brickless.physics}, {@code brickless.kernel}, {@code brickless.world},
 * {@code brickless.units}.
 */
package brickless.device.sensor;
