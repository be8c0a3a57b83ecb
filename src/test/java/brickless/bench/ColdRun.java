package brickless.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The demo from the command line, from the start of a new JVM to the summary, all files written. It is the installed
 * program if there is one (system property {@code brickless.install}), else the classes of this JVM's class path.
 */
final class ColdRun implements Measurement {
    private static final String PROGRAM = "sim/programs/explorer/Explorer.java";
    private static final int LIMIT_SECONDS = 60;
    /** What the shell prints of its children's times, on the last line. */
    private static final Pattern TIMES = Pattern.compile("(\\d+)m([\\d.]+)s (\\d+)m([\\d.]+)s\\s*$");

    @Override
    public Figures measure(Effort effort) throws Exception {
        Path folder = Files.createTempDirectory("brickless-bench");
        Figures[] rounds = new Figures[effort.nest() ? 2 * effort.rounds() - 1 : 1];
        for (int i = 0; i < rounds.length; i++) {
            rounds[i] = round(folder, effort);
        }
        return ProgramSpeed.medians(rounds);
    }

    private static Figures round(Path folder, Effort effort) throws IOException, InterruptedException {
        Path log = folder.resolve("log.txt");
        ProcessBuilder builder = new ProcessBuilder(command(folder.resolve("out"), effort)).redirectErrorStream(true)
                .redirectOutput(log.toFile());
        builder.environment().put("BRICKLESS_JAVA", java());
        long begin = System.nanoTime();
        Process process = builder.start();
        if (!process.waitFor(LIMIT_SECONDS, TimeUnit.SECONDS)) {
            process.destroyForcibly();
            throw new IllegalStateException("the demo did not end within a minute");
        }
        double seconds = (System.nanoTime() - begin) / 1e9;
        String text = Files.readString(log);
        Matcher times = TIMES.matcher(text);
        if (process.exitValue() != 0 || !times.find()) {
            throw new IllegalStateException("the demo ended with " + process.exitValue() + ": " + text);
        }
        return new Figures().put("wallSeconds", seconds).put("cpuSeconds", seconds(times, 1) + seconds(times, 3));
    }

    private static double seconds(Matcher times, int group) {
        return 60 * Double.parseDouble(times.group(group)) + Double.parseDouble(times.group(group + 1));
    }

    private static String java() {
        return Path.of(System.getProperty("java.home"), "bin", "java").toString();
    }

    private static List<String> command(Path out, Effort effort) {
        List<String> command = new ArrayList<>(List.of("sh", "-c", "\"$@\"; status=$?; times; exit $status", "sh"));
        String install = System.getProperty("brickless.install", "");
        if (install.isEmpty()) {
            command.addAll(List.of(java(), "-Xss1m", "-XX:+UseSerialGC", "-Djava.awt.headless=true"));
            command.addAll(Child.VIRTUAL_TIME);
            command.addAll(List.of("-cp", System.getProperty("java.class.path"), "brickless.cli.Main"));
        } else {
            command.add(Path.of(install, "bin", "brickless").toString());
        }
        command.addAll(List.of("run", Path.of(System.getProperty("brickless.home"), PROGRAM).toString(), "--for",
                effort.nest() ? "60s" : "1s", "--out", out.toString()));
        return command;
    }
}
