package brickless.simulation;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** Which program this JVM is running. */
final class RunningProgram {
    private RunningProgram() {}

    /**
     * The class whose {@code main} this JVM was started with, if its class file can be read: from the calling thread's
     * stack, else from the JVM's command line.
     */
    static Optional<String> mainClass() {
        List<StackWalker.StackFrame> frames = StackWalker.getInstance().walk(Stream::toList);
        String outermost = frames.get(frames.size() - 1).getClassName();
        String command = System.getProperty("sun.java.command", "").split(" ", 2)[0];
        return Stream.of(outermost, command.substring(command.indexOf('/') + 1))
                .filter(RunningProgram::isProgram).findFirst();
    }

    private static boolean isProgram(String className) {
        boolean library = Stream.of("java.", "jdk.", "sun.", "org.junit.").anyMatch(className::startsWith);
        return !className.isEmpty() && !library
                && Thread.currentThread().getContextClassLoader()
                .getResource(className.replace('.', '/') + ".class") != null;
    }
}
