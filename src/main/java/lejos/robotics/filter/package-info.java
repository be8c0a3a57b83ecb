/**
 * Filters: sample providers that stand in front of another one and change what it says.
 *
 * <p>A filter takes one sample of its source for each sample asked of it, so filters can be chained. Unless said
 * otherwise they are for one thread. May use: the JDK, {@code lejos.robotics}, {@code lejos.hardware},
 * {@code lejos.utility}.
 */
package lejos.robotics.filter;
