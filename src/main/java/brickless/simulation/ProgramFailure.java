package brickless.simulation;

import brickless.trace.Decimals;
import java.awt.HeadlessException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;

/** Tells an exception of the program in the program's own terms: its own lines only, and the simulated time. */
final class ProgramFailure {
    private static final List<String> FOREIGN = List.of("java.", "javax.", "jdk.", "sun.", "brickless.", "lejos.");

    private static final String NO_WINDOWS = ": a brick has no windows, this part of the program is for a PC";

    private ProgramFailure() {}

    static String describe(String thread, Throwable failure, long timeNanos) {
        StringBuilder text = new StringBuilder("Exception in thread \"" + thread + "\" after "
                + Decimals.seconds(timeNanos) + " simulated seconds: ");
        Set<Throwable> seen = Collections.newSetFromMap(new IdentityHashMap<>());
        for (Throwable each = failure; each != null && seen.add(each); each = each.getCause()) {
            text.append(each == failure ? "" : "\nCaused by: ").append(each)
                    .append(each instanceof HeadlessException ? NO_WINDOWS : "");
            for (StackTraceElement frame : ownFrames(each)) {
                text.append("\n\tat ").append(frame.getClassName()).append('.').append(frame.getMethodName())
                        .append('(').append(frame.getFileName())
                        .append(frame.getLineNumber() > 0 ? ":" + frame.getLineNumber() : "").append(')');
            }
        }
        return text.toString();
    }

    private static List<StackTraceElement> ownFrames(Throwable failure) {
        List<StackTraceElement> own = new ArrayList<>();
        for (StackTraceElement frame : failure.getStackTrace()) {
            if (FOREIGN.stream().noneMatch(frame.getClassName()::startsWith)) {
                own.add(frame);
            }
        }
        return own;
    }
}
