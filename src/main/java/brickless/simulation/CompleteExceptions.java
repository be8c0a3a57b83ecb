package brickless.simulation;

import java.lang.management.ManagementFactory;
import java.util.List;

/**
 * Whether the JVM gives all exceptions their messages and stack traces. By default it leaves them out of a
 * {@code NullPointerException}, {@code ArrayIndexOutOfBoundsException} and the like once compiled code has thrown some:
 * programs could tell compiled classes from new ones.
 */
final class CompleteExceptions {
    /** Grants them. */
    private static final String OPTION = "-XX:-OmitStackTraceInFastThrow";
    private static final boolean GRANTED =
            areGrantedBy(ManagementFactory.getRuntimeMXBean().getInputArguments());

    private CompleteExceptions() {}

    /** In this JVM. */
    static boolean areGranted() {
        return GRANTED;
    }

    /** With these options; the last of contradicting ones counts. */
    static boolean areGrantedBy(List<String> options) {
        return options.lastIndexOf(OPTION) > options.lastIndexOf(OPTION.replace(":-", ":+"));
    }
}
