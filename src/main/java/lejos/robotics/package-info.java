/**
 * What robots are made of, in terms a program can use without knowing the maker: motors, encoders, range finders,
 * colours.
 *
 * <p>Mostly interfaces, with adapters that turn a {@link lejos.robotics.SampleProvider} into one of them.
 * May use: the JDK, {@code lejos.utility}, {@code lejos.hardware} in adapters.
 */
package lejos.robotics;
