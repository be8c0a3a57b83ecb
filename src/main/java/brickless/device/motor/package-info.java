/**
 * Motors: DC model, encoder, and the controller that leJOS expects in the brick (planner, tracking loop, stall, hold).
 *
 * <p>May use: {@code brickless.hardware}, {@code brickless.physics}, {@code brickless.kernel}, {@code brickless.world},
 * {@code brickless.units}, {@code brickless.device.battery}.
 */
package brickless.device.motor;
