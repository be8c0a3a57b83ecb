/**
 * Connections between bricks in the manner of the NXT. Virtual bricks are out of each other's reach. May use: the JDK.
 */
package lejos.remote.nxt;
