/** What drivers of third-party devices have in common. May use: the JDK. */
package lejos.hardware.device;
