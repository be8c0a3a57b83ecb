/** What drivers of third-party devices have in common. Uses {@code lejos.hardware} and the JDK. */
package lejos.hardware.device;
