package brickless.simulation;

import com.sun.management.HotSpotDiagnosticMXBean;
import java.lang.management.ManagementFactory;

/**
 * Whether the JVM gives all exceptions their messages and stack traces. By default it leaves them out of a
 * {@code NullPointerException}, {@code ArrayIndexOutOfBoundsException} and the like once compiled code has thrown a few:
 * programs could tell compiled classes from new ones.
 */
final class CompleteExceptions {
    /** The option {@code -XX:-OmitStackTraceInFastThrow} grants them. */
    private static final String OMIT = "OmitStackTraceInFastThrow";
    private static final boolean GRANTED = areGrantedByOption();

    private CompleteExceptions() {}

    static boolean areGranted() {
        return GRANTED;
    }

    private static boolean areGrantedByOption() {
        HotSpotDiagnosticMXBean vm = ManagementFactory.getPlatformMXBean(HotSpotDiagnosticMXBean.class);
        return vm != null && vm.getVMOption(OMIT).getValue().equals("false");
    }
}
