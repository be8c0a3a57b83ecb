package brickless.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code brickless explore} finds what only some schedules show, and says how to see it again. */
class ExploreCommandTest {
    private static final String LOCK_ORDER = """
            public class LockOrder {
                static final Object left = new Object(), right = new Object();
                static int steps;
                static Thread taking(Object first, Object second) {
                    return new Thread(() -> {
                        for (int i = 0; i < 3; i++) {
                            synchronized (first) {
                                steps++;
                                synchronized (second) { steps++; }
                            }
                        }
                    });
                }
                public static void main(String[] args) {
                    taking(left, right).start();
                    taking(right, left).start();
                }
            }
            """;
    private static final String LOST_UPDATE = """
            public class LostUpdate {
                static int count;
                static final Object lock = new Object();
                static int read() { synchronized (lock) { return count; } }
                static void write(int value) { synchronized (lock) { count = value; } }
                public static void main(String[] args) throws InterruptedException {
                    Thread[] threads = new Thread[2];
                    for (int i = 0; i < 2; i++) {
                        threads[i] = new Thread(() -> { for (int k = 0; k < 5; k++) { write(read() + 1); } });
                        threads[i].start();
                    }
                    for (Thread thread : threads) { thread.join(); }
                    if (count != 10) { throw new IllegalStateException("counted " + count); }
                }
            }
            """;

    @TempDir Path folder;

    private Path program(String name, String text) throws IOException {
        return Files.writeString(folder.resolve(name + ".java"), text);
    }

    /** Runs the printed command again. */
    private CommandLineRun again(String out) {
        Matcher command = Pattern.compile("see it again: brickless (.*)").matcher(out);
        assertThat(command.find()).as(out).isTrue();
        List<Object> words = new ArrayList<>(List.of((Object[]) command.group(1).split(" ")));
        words.addAll(List.of("--out", folder.resolve("again"), "--json"));
        return CommandLineRun.of(words.toArray());
    }

    @Test
    void aLockOrderDeadlockIsFoundAndReplayed() throws IOException {
        Path program = program("LockOrder", LOCK_ORDER);
        assertThat(CommandLineRun.of("run", program, "--out", folder.resolve("plain")).status())
                .as("round-robin does not show it").isZero();
        CommandLineRun found = CommandLineRun.of("explore", program, "--schedules", 80);
        assertThat(found.status()).as(found.out()).isEqualTo(1);
        assertThat(found.out()).contains("deadlock: ").contains("of 80, first with schedule seed ")
                .contains("LockOrder.java:9");
        assertThat(again(found.out()).lastLine()).contains("\"outcome\":\"deadlock\"");
    }

    @Test
    void aLostUpdateIsFoundAndReplayed() throws IOException {
        Path program = program("LostUpdate", LOST_UPDATE);
        assertThat(CommandLineRun.of("run", program, "--out", folder.resolve("plain")).status())
                .as("round-robin does not show it").isZero();
        CommandLineRun found = CommandLineRun.of("explore", program, "--schedules", 80);
        assertThat(found.status()).as(found.out()).isEqualTo(1);
        assertThat(found.out()).contains("failed: ").contains("IllegalStateException: counted ");
        assertThat(again(found.out()).lastLine()).contains("\"outcome\":\"failed\"").contains("counted ");
    }

    @Test
    void aSoundProgramPassesAllSchedules() throws IOException {
        Path program = program("Sound", LOST_UPDATE.replace("LostUpdate", "Sound").replace("write(read() + 1);",
                "synchronized (lock) { write(read() + 1); }"));
        CommandLineRun run = CommandLineRun.of("explore", program, "--schedules", 40);
        assertThat(run.status()).as(run.out()).isZero();
        assertThat(run.out()).contains("40 schedules: no failure");
    }
}
