package brickless.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.bench.InstalledJdks;
import brickless.program.ProgramException;
import brickless.world.DescriptionException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The same run in new Java virtual machines, of every JDK that is installed, on idle and on busy processors. */
class FreshJvmTest {
    private static final String MAIN = "explorer.Explorer";
    private static final Pattern HASH = Pattern.compile("\"traceHash\":\"(\\w{64})\"");

    @TempDir Path folder;
    private static ExamplePrograms programs;
    private static String here;

    @BeforeAll
    static void runHere() throws ProgramException, DescriptionException {
        programs = ExamplePrograms.compiled();
        Run run = new Simulation(ExamplePrograms.settings("pen").limit(Duration.ofSeconds(6)).build())
                .start(programs.program(MAIN));
        run.toEnd();
        here = run.report().traceHash();
    }

    @AfterAll
    static void removeClasses() {
        programs.close();
    }

    private static List<Path> jdks() throws IOException {
        return InstalledJdks.homes().stream().limit(3).toList();
    }

    private String hashIn(Path home, String... vmOptions) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of(home.resolve("bin/java").toString(), "-Djava.awt.headless=true",
                "--add-exports=java.base/jdk.internal.vm=ALL-UNNAMED", "--add-opens=java.base/java.lang=ALL-UNNAMED"));
        command.addAll(List.of(vmOptions));
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), "brickless.cli.Main", "run", MAIN,
                "--classpath",
                programs.program(MAIN).classPath().get(0).toString(), "--robot", "educator", "--for", "6s", "--json",
                "--out",
                folder.resolve("out").toString()));
        Path out = folder.resolve("out.txt");
        Process process = new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(out.toFile())
                .directory(folder.toFile()).start();
        assertThat(process.waitFor(120, TimeUnit.SECONDS)).as("ended in time").isTrue();
        String text = Files.readString(out, StandardCharsets.UTF_8);
        Matcher hash = HASH.matcher(text);
        assertThat(hash.find()).as(text).isTrue();
        return hash.group(1);
    }

    @Test
    void everyInstalledJdkGivesTheSameRun() throws Exception {
        for (Path home : jdks()) {
            assertThat(hashIn(home)).as("in a new JVM of %s", home).isEqualTo(here);
        }
    }

    @Test
    void hostSettingsDoNotEnterTheRun() throws Exception {
        assertThat(hashIn(jdks().get(0), "-Duser.language=tr", "-Duser.country=TR", "-Duser.timezone=Asia/Kathmandu",
                "-Dfile.encoding=ISO-8859-1",
                "-Dline.separator=\r\n", "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC", "-XX:ActiveProcessorCount=1"))
                .isEqualTo(here);
    }

    @Test
    void busyProcessorsDoNotEnterTheRun() throws Exception {
        AtomicBoolean done = new AtomicBoolean();
        List<Thread> load = Stream.generate(() -> new Thread(() -> {
            while (!done.get()) {
                Thread.onSpinWait();
            }
        })).limit(Runtime.getRuntime().availableProcessors()).toList();
        load.forEach(Thread::start);
        try {
            assertThat(hashIn(jdks().get(0))).isEqualTo(here);
        } finally {
            done.set(true);
        }
    }
}
