package brickless.bench;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** What else happens on the host during a measurement. */
enum Conditions {
    /** Nothing that we know of. */
    IDLE,
    /** All cores are kept busy by another process. */
    BUSY,
    /** One core only. */
    ONE_CORE;

    private static final Path TASKSET = Path.of("/usr/bin/taskset");

    /** What is put before a JVM's command. */
    List<String> prefix() {
        return this == ONE_CORE && Files.isExecutable(TASKSET) ? List.of(TASKSET.toString(), "-c", "0") : List.of();
    }

    /** Options of the JVM; without {@code taskset} it at least believes that there is but one core. */
    List<String> vmOptions() {
        return this == ONE_CORE ? List.of("-XX:ActiveProcessorCount=1") : List.of();
    }
}
