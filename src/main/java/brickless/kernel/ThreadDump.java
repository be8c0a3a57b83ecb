package brickless.kernel;

import brickless.kernel.hooks.NamedMonitor;
import java.util.Arrays;
import java.util.List;

/** The program's threads in the program's own terms: names, states, locks and its own source lines. */
final class ThreadDump {
    private static final List<String> NOT_THE_PROGRAMS =
            List.of("brickless.", "lejos.internal.", "java.", "javax.", "jdk.", "sun.", "com.sun.");
    /** In the names of the JDK's own classes behind lambdas. */
    private static final String LAMBDA_PROXY = "$$Lambda";
    private static final int MICROS_PER_MILLI = 1_000;
    private static final int NANOS_PER_MICRO = 1_000;

    private final Backend backend;
    private final StringBuilder text = new StringBuilder();

    ThreadDump(String title, long timeNanos, Backend backend) {
        this.backend = backend;
        long micros = timeNanos / NANOS_PER_MICRO;
        String fraction = Long.toString(MICROS_PER_MILLI + micros % MICROS_PER_MILLI).substring(1);
        text.append(title).append(" at ").append(micros / MICROS_PER_MILLI).append('.').append(fraction)
                .append(" ms\n");
    }

    /** Lists fibres; from any thread. */
    String of(List<Fibre> fibres) {
        for (Fibre fibre : fibres) {
            append(fibre);
        }
        return text.toString();
    }

    private void append(Fibre fibre) {
        text.append(name(fibre)).append(' ').append(fibre.threadState());
        appendReason(fibre);
        StackTraceElement[] frames = fibre.begun ? programFrames(fibre) : new StackTraceElement[0];
        if (frames.length > 0) {
            text.append(" at ").append(frames[0].getFileName()).append(':').append(frames[0].getLineNumber());
        }
        text.append('\n');
        for (StackTraceElement frame : frames) {
            text.append("    at ").append(frame).append('\n');
        }
    }

    private StackTraceElement[] programFrames(Fibre fibre) {
        return Arrays.stream(backend.stackOf(fibre)).filter(ThreadDump::isPrograms).map(ThreadDump::inShort)
                .toArray(StackTraceElement[]::new);
    }

    private void appendReason(Fibre fibre) {
        switch (fibre.state) {
            case BLOCKED -> {
                appendLock(fibre);
                if (fibre.monitor.owner != null) {
                    text.append(" held by ").append(name(fibre.monitor.owner));
                }
            }
            case WAITING -> appendWait(fibre);
            case JOINING -> text.append(" for the end of ").append(name(fibre.joined));
            case SIGNAL, SIGNAL_INTERRUPTIBLY -> text.append(" for a device");
            case EXITING -> text.append(" for shutdown hooks");
            default -> { }
        }
    }

    private void appendWait(Fibre fibre) {
        if (fibre.blocker == null) {
            appendLock(fibre);
        } else {
            Thread owner = fibre.blocker.lockOwner();
            text.append(" for a lock").append(owner == null ? "" : " held by \"" + owner.getName() + '"');
        }
    }

    private void appendLock(Fibre fibre) {
        text.append(" on ").append(nameOf(fibre.monitor.lock));
    }

    private static String nameOf(Object lock) {
        if (lock instanceof NamedMonitor named) {
            return named.monitorName();
        }
        return lock instanceof Class<?> type ? "class " + type.getName() : lock.getClass().getName();
    }

    private static String name(Fibre fibre) {
        return '"' + fibre.thread.getName() + '"';
    }

    private static boolean isPrograms(StackTraceElement frame) {
        String type = frame.getClassName();
        return !type.contains(LAMBDA_PROXY) && NOT_THE_PROGRAMS.stream().noneMatch(type::startsWith);
    }

    /** Without module and class loader, which say nothing to the program's author. */
    private static StackTraceElement inShort(StackTraceElement frame) {
        return new StackTraceElement(
                frame.getClassName(), frame.getMethodName(), frame.getFileName(), frame.getLineNumber());
    }
}
