package brickless.junit;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Inherited;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * A test, or a class of tests, whose body is a robot program: it uses {@code lejos} classes, and it runs on the virtual
 * brick in virtual time.
 *
 * <p>Inside the simulation the class is loaded anew, an instance made, and {@code @BeforeEach} methods, the test and
 * {@code @AfterEach} methods called there. What the test throws is the test's failure. Outside, JUnit makes an instance
 * too: fields that open devices belong into {@code @BeforeEach}. Threads still running when the test returns are ended.
 * Parameters may be of JDK and JUnit types only.
 */
@Target({ElementType.TYPE, ElementType.METHOD})
@Retention(RetentionPolicy.RUNTIME)
@Inherited
@Documented
@ExtendWith(SimulationExtension.class)
public @interface OnTheBrick {}
