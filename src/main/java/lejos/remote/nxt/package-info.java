/**
 * Connections between bricks in the manner of the NXT.
 *
 * <p>Virtual bricks are out of each other's reach by Bluetooth; sockets are those of the host. May use: the JDK, {@code
 * lejos.utility}.
 */
package lejos.remote.nxt;
