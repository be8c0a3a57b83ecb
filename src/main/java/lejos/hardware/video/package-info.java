/** The camera API of leJOS. A virtual brick has no camera. May use: the JDK, {@code lejos.hardware.lcd}. */
package lejos.hardware.video;
