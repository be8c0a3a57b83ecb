/** Small programs that do one thing, for tests that run them on a simulated brick. */
package lejos.programs;
