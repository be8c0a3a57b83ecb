/**
 * Models of the brick's front: screen, keys, LEDs and loudspeaker, with the automatic button presses of unattended runs
 * and pictures of the screen. They implement the sockets of {@code brickless.hardware} and report to a {@link
 * brickless.device.panel.PanelListener}.
 *
 * <p>Program threads call the sockets; the simulation calls {@code step} at each physics step. Every mutable field is
 * guarded by the monitor of its object, which is never held while time is charged or a thread blocks. May use: {@code
 * brickless.hardware}, {@code brickless.kernel}.
 */
package brickless.device.panel;
