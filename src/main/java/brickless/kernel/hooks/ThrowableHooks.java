package brickless.kernel.hooks;

import java.io.PrintStream;
import java.io.PrintWriter;

/** {@code Throwable} of rewritten code: traces hold program frames only. Per robot. */
public final class ThrowableHooks {
    private ThrowableHooks() {}

    /** {@code failure.printStackTrace()}. */
    public static void printStackTrace(Throwable failure) {
        printStackTrace(failure, Hooks.machine().err());
    }

    /** {@code failure.printStackTrace(stream)}. */
    public static void printStackTrace(Throwable failure, PrintStream stream) {
        stream.print(ThrowableText.trace(failure));
    }

    /** {@code failure.printStackTrace(writer)}. */
    public static void printStackTrace(Throwable failure, PrintWriter writer) {
        writer.print(ThrowableText.trace(failure));
    }

    /** {@code failure.getStackTrace()}. */
    public static StackTraceElement[] getStackTrace(Throwable failure) {
        return ThrowableText.programFrames(failure.getStackTrace());
    }

    /** {@code failure.getMessage()}. */
    public static String getMessage(Throwable failure) {
        return ThrowableText.message(failure);
    }
}
