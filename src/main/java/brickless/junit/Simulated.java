package brickless.junit;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Inherited;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * Gives the tests of a class, or one test, a simulated world and robot.
 *
 * <p>Test methods may then have a parameter of type {@link brickless.simulation.Simulation}, or, if {@link #program} is
 * given, of type {@link brickless.simulation.Run}: the program, standing still before its first instruction. What an
 * annotation on a method leaves out is taken from the one on the class. Every test has its own simulation; runs that a
 * test leaves open are closed after it.
 */
@Target({ElementType.TYPE, ElementType.METHOD})
@Retention(RetentionPolicy.RUNTIME)
@Inherited
@Documented
@ExtendWith(SimulationExtension.class)
public @interface Simulated {
    /** A seed that stands for "not given". */
    long NO_SEED = Long.MIN_VALUE;

    /** World: file (relative to the working directory), bundled name, or the SVG text itself. Default: {@code pen}. */
    String world() default "";

    /** Robot: file, bundled name, SVG text, or {@code auto}: fitted to the program, the default. */
    String robot() default "";

    /** Seed of noise and of the program's random numbers. Default: 1. */
    long seed() default NO_SEED;

    /** Limit in simulated seconds, at which runs end. Default: 60. */
    int seconds() default 0;

    /** Whether noise, latency and slip are off. */
    boolean ideal() default false;

    /** {@code auto} (default): keys that the program waits for are pressed; {@code none}: never. */
    String buttons() default "";

    /** What happens to the robot, in the lines of a stimuli file: {@code "5s press ESCAPE 200ms"}. */
    String[] stimuli() default {};

    /**
     * Folder (relative to the working directory) whose content lies on the brick, in {@code /home/lejos/programs}, when
     * a run begins; it is not changed. Default: none.
     */
    String files() default "";

    /** Class with the main method for parameters of type {@code Run}. */
    Class<?> program() default void.class;
}
