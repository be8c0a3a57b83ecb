/** Text and graphics on the brick's screen. May use: {@code brickless.hardware}, the JDK. */
package lejos.hardware.lcd;
