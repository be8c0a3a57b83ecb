package brickless.junit;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.TestTemplate;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * A test that is run once for each of several seeds, instead of {@code @Test}; the seed goes into its simulation.
 *
 * <pre>
 * &#64;Seeds("1..20") void findsTheGoal(Simulation simulation) { … }
 * </pre>
 */
@Target(ElementType.METHOD)
@Retention(RetentionPolicy.RUNTIME)
@Documented
@TestTemplate
@ExtendWith({SimulationExtension.class, SeedsProvider.class})
public @interface Seeds {
    /** Seeds: numbers and ranges, separated by commas: {@code "1..20"}, {@code "1, 5, 100..110"}. */
    String value();
}
