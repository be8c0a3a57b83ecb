package brickless.bench;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;

/**
 * Measures how fast Brickless is and prints a table: {@code Bench [--cases a,b] [--jdks 17,25] [--effort
 * full|short|trial] [--out FILE]}. Every case runs in a new JVM of every installed JDK.
 */
public final class Bench {
    private final PrintStream out;
    private List<BenchCase> cases = BenchCase.ALL;
    private List<Integer> versions = List.of();
    private String effort = "full";
    private Path file = Path.of("build", "bench.json");

    Bench(PrintStream out, String... args) {
        this.out = out;
        if (args.length % 2 != 0) {
            throw new IllegalArgumentException("every option needs a value: " + String.join(" ", args));
        }
        for (int i = 0; i < args.length; i += 2) {
            option(args[i], args[i + 1]);
        }
    }

    /** Runs the benchmarks. */
    public static void main(String[] args) throws Exception {
        new Bench(System.out, args).run();
    }

    private void option(String name, String value) {
        switch (name) {
            case "--cases" -> cases = Arrays.stream(value.split(",")).flatMap(Bench::matching).toList();
            case "--jdks" -> versions = Arrays.stream(value.split(",")).map(Integer::valueOf).toList();
            case "--effort" -> {
                Effort.of(value);
                effort = value;
            }
            case "--out" -> file = Path.of(value);
            default -> throw new IllegalArgumentException("unknown option " + name);
        }
    }

    /** A case by its name, or all of a group. */
    private static Stream<BenchCase> matching(String name) {
        List<BenchCase> group = BenchCase.ALL.stream().filter(bench -> bench.group().equals(name)).toList();
        return group.isEmpty() ? Stream.of(BenchCase.named(name)) : group.stream();
    }

    void run() throws IOException, InterruptedException {
        Table table = new Table();
        for (Path jdk : jdks()) {
            for (BenchCase bench : cases) {
                Figures figures = measure(jdk, bench);
                Table.Row row = table.add(bench, InstalledJdks.version(jdk), figures);
                out.println(bench.name() + " on JDK " + row.jdk() + ": " + row.figures().json());
            }
        }
        out.println();
        out.print(table.text());
        Files.createDirectories(file.toAbsolutePath().getParent());
        Files.writeString(file, table.json(effort) + "\n");
    }

    private List<Path> jdks() throws IOException {
        List<Path> chosen = new ArrayList<>();
        for (Path home : InstalledJdks.homes()) {
            if (versions.isEmpty() || versions.contains(InstalledJdks.version(home))) {
                chosen.add(home);
            }
        }
        if (chosen.isEmpty()) {
            throw new IllegalStateException("none of the JDKs " + versions + " is installed");
        }
        return chosen;
    }

    private Figures measure(Path jdk, BenchCase bench) throws IOException, InterruptedException {
        if (bench.conditions() != Conditions.BUSY) {
            return Child.measure(jdk, bench, effort);
        }
        try (BusyHost busy = new BusyHost()) {
            return Child.measure(jdk, bench, effort);
        }
    }
}
