package brickless.kernel.hooks;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;

/**
 * Exceptions in program terms: no frames of the simulator or of the running JDK, whose names and lines differ between
 * versions, and no loader identities in messages. Shared; the kernel uses it for uncaught exceptions and dumps.
 */
public final class ThrowableText {
    private static final String[] HIDDEN =
            {"java.", "javax.", "jdk.", "sun.", "com.sun.", "brickless.kernel.", "brickless.loading.",
        "brickless.concurrent.", "brickless.simulation.", "lejos.internal."};
    private static final String INITIALISER = "$clinit$";
    private static final Set<String> INITIALISER_TRIGGERS = Set.of("$init", "$initialize");
    private static final String INTERFACE_STATICS = "$$Statics";

    private ThrowableText() {}

    /** The frames of {@code frames} that belong to the program or to leJOS, without loader and module names. */
    public static StackTraceElement[] programFrames(StackTraceElement[] frames) {
        List<StackTraceElement> kept = new ArrayList<>();
        for (StackTraceElement frame : frames) {
            if (isOfProgram(frame)) {
                String method = INITIALISER.equals(frame.getMethodName()) ? "<clinit>" : frame.getMethodName();
                kept.add(new StackTraceElement(frame.getClassName().replace(INTERFACE_STATICS, ""), method,
                        frame.getFileName(), frame.getLineNumber()));
            }
        }
        return kept.toArray(new StackTraceElement[0]);
    }

    private static boolean isOfProgram(StackTraceElement frame) {
        for (String prefix : HIDDEN) {
            if (frame.getClassName().startsWith(prefix)) {
                return false;
            }
        }
        return !INITIALISER_TRIGGERS.contains(frame.getMethodName());
    }

    /** {@code failure.getMessage()} without the identity of a class loader, or null. */
    public static String message(Throwable failure) {
        return withoutLoaderIdentity(failure.getMessage());
    }

    /** {@code failure.toString()} without the identity of a class loader. */
    public static String summary(Throwable failure) {
        return withoutLoaderIdentity(failure.toString());
    }

    private static String withoutLoaderIdentity(String text) {
        return text == null || text.indexOf('@') < 0 ? text
                : text.replaceAll("(loader '[^']*'|loader [\\w.$]+) @[0-9a-f]+", "$1");
    }

    /** The whole trace, causes included, in the JDK's layout, lines ended by {@code \n}. */
    public static String trace(Throwable failure) {
        StringBuilder text = new StringBuilder();
        append(text, failure, "", "", Collections.newSetFromMap(new IdentityHashMap<>()));
        return text.toString();
    }

    private static void append(StringBuilder text, Throwable failure, String caption, String indent,
            Set<Throwable> shown) {
        if (!shown.add(failure)) {
            text.append(indent).append(caption).append("[CIRCULAR REFERENCE: ").append(summary(failure)).append("]\n");
            return;
        }
        text.append(indent).append(caption).append(summary(failure)).append('\n');
        for (StackTraceElement frame : programFrames(failure.getStackTrace())) {
            text.append(indent).append("\tat ").append(frame).append('\n');
        }
        for (Throwable suppressed : failure.getSuppressed()) {
            append(text, suppressed, "Suppressed: ", indent + "\t", shown);
        }
        if (failure.getCause() != null) {
            append(text, failure.getCause(), "Caused by: ", indent, shown);
        }
    }
}
