package brickless.bench;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** A new JVM that measures one case and prints the figures as its last line: {@code Child CASE EFFORT}. */
public final class Child {
    /** What lets threads of programs be continuations, and runs use classes again. */
    static final List<String> VIRTUAL_TIME = List.of("--add-exports=java.base/jdk.internal.vm=ALL-UNNAMED",
            "--add-opens=java.base/java.lang=ALL-UNNAMED", "-XX:-OmitStackTraceInFastThrow");

    private Child() {}

    /** Measures. */
    public static void main(String[] args) throws Exception {
        System.out.println(BenchCase.named(args[0]).measurement().measure(Effort.of(args[1])).json());
        System.exit(0);
    }

    /** Measures a case in a JVM of the JDK with this home. */
    static Figures measure(Path jdk, BenchCase bench, String effort) throws IOException, InterruptedException {
        Process process = new ProcessBuilder(command(jdk, bench, effort))
                .redirectError(ProcessBuilder.Redirect.INHERIT).start();
        String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        if (process.waitFor() != 0) {
            throw new IllegalStateException(bench.name() + " failed on " + jdk + ": " + out);
        }
        return Figures.parse(out.strip().lines().reduce((first, last) -> last).orElse(""));
    }

    private static List<String> command(Path jdk, BenchCase bench, String effort) {
        List<String> command = new ArrayList<>(bench.conditions().prefix());
        command.addAll(List.of(jdk.resolve("bin/java").toString(), "-XX:+UseSerialGC", "-Xss1m", "-Xmx" + bench.heap(),
                "-Djava.awt.headless=true", "-Dorg.slf4j.simpleLogger.defaultLogLevel=warn"));
        command.addAll(bench.conditions().vmOptions());
        command.addAll(VIRTUAL_TIME);
        for (String name : new String[] {"brickless.home", "brickless.install", "java.io.tmpdir"}) {
            command.add("-D" + name + "=" + System.getProperty(name, ""));
        }
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), Child.class.getName(),
                bench.name(), effort));
        return command;
    }
}
