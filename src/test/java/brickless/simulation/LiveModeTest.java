package brickless.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.program.Program;
import brickless.program.ProgramFinder;
import java.io.File;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Programs started as plain Java in a JVM of their own, paced to the wall clock. */
class LiveModeTest {
    private static final Path PROGRAMS = Path.of(System.getProperty("brickless.home", ""), "sim", "programs");
    /** Far more than any of these programs needs, for machines that are busy. */
    private static final long PATIENCE_SECONDS = 120;

    @TempDir
    private Path folder;

    private record Ended(int status, String out, String err) {}

    private Ended run(Path source, String... properties) throws Exception {
        try (Program program = new ProgramFinder(folder, List.of(), Optional.empty())
                .find(source.toAbsolutePath().toString())) {
            List<String> command = new ArrayList<>(
                    List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString()));
            command.addAll(List.of(properties));
            command.addAll(List.of("-cp", program.classPath().get(0) + File.pathSeparator
                    + System.getProperty("java.class.path"), program.mainClass()));
            Path out = folder.resolve("out.txt");
            Path err = folder.resolve("err.txt");
            Process process = new ProcessBuilder(command).directory(folder.toFile()).redirectOutput(out.toFile())
                    .redirectError(err.toFile()).start();
            boolean ended = process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS);
            process.destroyForcibly();
            String errors = Files.readString(err);
            assertThat(ended).as("ended by itself; " + errors).isTrue();
            return new Ended(process.exitValue(), Files.readString(out), errors);
        }
    }

    private Path source(String name, String body) throws Exception {
        Path file = folder.resolve(name + ".java");
        return Files.writeString(file, "import lejos.hardware.motor.Motor;\npublic class " + name
                + " {\n    public static void main(String[] args) throws Exception {\n" + body + "\n    }\n}\n",
                StandardCharsets.UTF_8);
    }

    @Test
    void aProgramWithBusyLoopsDrivesAndEndsAndLeavesTheFilesOfItsRun() throws Exception {
        Path files = folder.resolve("run");
        Ended ended = run(PROGRAMS.resolve("busywait/BusyWait.java"), "-Dbrickless.out=" + files);
        assertThat(ended.status()).isZero();
        assertThat(ended.out().strip()).matches("-?[01] -?[01]");
        assertThat(ended.err()).contains("BusyWait in pen: exited after").contains("files in " + files);
        assertThat(files.resolve("console.txt")).hasContent(ended.out());
        assertThat(files).isDirectoryContaining("glob:**/trace.jsonl").isDirectoryContaining("glob:**/report.html");
        assertThat(files).isDirectoryNotContaining("glob:**.part");
    }

    @Test
    void theExampleOfTheDocumentationRunsAsItSays() throws Exception {
        String page = Files.readString(PROGRAMS.resolve("../docs/LIVE-MODE.md"));
        Path source = Files.writeString(folder.resolve("Turn.java"), fenced(page, "```java\n"));
        String[] words = fenced(page, "```\njava ").strip().split(" ");
        assertThat(words[words.length - 1]).isEqualTo("Turn");
        Ended ended = run(source, Arrays.copyOf(words, words.length - 1));
        assertThat(page).contains("prints `" + ended.out().strip() + "`");
        assertThat(ended.err()).contains("Turn in line-loop: exited after");
        assertThat(folder.resolve("run/summary.json")).content().contains("\"robot\":\"educator\"");
    }

    private static String fenced(String page, String opening) {
        int begin = page.indexOf(opening) + opening.length();
        return page.substring(begin, page.indexOf("```", begin));
    }

    @Test
    void worldRobotAndSeedComeFromSystemProperties() throws Exception {
        Path files = folder.resolve("run");
        Ended ended = run(source("Silent", "Motor.A.getTachoCount();"), "-Dbrickless.world=line-loop",
                "-Dbrickless.robot=educator", "-Dbrickless.seed=42", "-Dbrickless.out=" + files);
        assertThat(ended.err()).contains("Silent in line-loop: exited after");
        assertThat(files.resolve("summary.json")).content().contains("\"world\":\"line-loop\"")
                .contains("\"robot\":\"educator\"").contains("\"seed\":42").contains("\"backend\":\"live\"");
    }

    @Test
    void anUncaughtExceptionIsPrintedAndFailsTheRun() throws Exception {
        Ended ended =
                run(source("Broken", "Motor.A.getTachoCount();\nthrow new IllegalStateException(\"wheel lost\");"));
        assertThat(ended.status()).isEqualTo(1);
        assertThat(ended.err()).contains("Exception in thread \"main\" java.lang.IllegalStateException: wheel lost")
                .contains("at Broken.main(Broken.java:5)").contains("Broken in pen: failed");
    }

    @Test
    void exitFromAnyThreadEndsTheRunWhileOthersUseTheBrick() throws Exception {
        Ended ended = run(source("Leaving",
                "Thread poll = new Thread(() -> { while (true) { Motor.B.getTachoCount(); } });\npoll.start();\n"
                + "Motor.B.forward();\nRuntime.getRuntime().addShutdownHook(new Thread(() -> "
                + "Motor.B.stop()));\nSystem.exit(3);"));
        assertThat(ended.status()).isEqualTo(3);
        assertThat(ended.err()).contains("Leaving in pen: exited");
    }

    @Test
    void aWorldThatIsNotThereIsNamed() throws Exception {
        Ended ended = run(source("Lost", "Motor.A.forward();"), "-Dbrickless.world=atlantis");
        assertThat(ended.status()).isEqualTo(1);
        assertThat(ended.err()).contains("SetupException: atlantis: no such world");
    }
}
