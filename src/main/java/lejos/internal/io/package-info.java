/**
 * Settings and the description of the Bluetooth radio, for programs that name these internals of leJOS. May use: the
 * JDK.
 */
package lejos.internal.io;
