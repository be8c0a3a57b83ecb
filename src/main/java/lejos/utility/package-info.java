/**
 * Delays, timers, menus, matrices and other small tools of leJOS. May use: {@code lejos.hardware}, {@code
 * lejos.robotics}, the JDK.
 */
package lejos.utility;
