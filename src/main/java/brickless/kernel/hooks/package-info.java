/**
 * Static methods that rewritten bytecode calls, and the interface through which they reach the kernel; inert (plain JDK behaviour) by default.
 * May use: the JDK.
 */
package brickless.kernel.hooks;
