/** Virtual time: clock, event queue, fibres, monitors, scheduling, deadlock and runaway detection. May use: {@code brickless.kernel.hooks}, the JDK. */
package brickless.kernel;
