/**
 * What a brick offers leJOS: motor and sensor sockets, screen, keys, LEDs, speaker, battery and program log.
 *
 * <p>Every type that crosses from a robot's own class loader to the shared simulator lives here or is a JDK type. May
 * use: the JDK.
 */
package brickless.hardware;
