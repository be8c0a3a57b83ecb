package brickless.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code brickless run}: exit status, the JSON line, the files, and what it says about programs that fail. */
class RunCommandTest {
    @TempDir Path folder;

    private Path source(String name, String body) throws IOException {
        return Files.writeString(folder.resolve(name + ".java"),
                "import lejos.hardware.*;\nimport lejos.utility.Delay;\npublic class " + name
                + " {\n    public static void main(String[] args) throws Exception {\n" + body + "\n    }\n}\n");
    }

    private CommandLineRun run(Path program, Object... options) {
        List<Object> words = new ArrayList<>(List.of("run", program, "--out", folder.resolve("out")));
        words.addAll(List.of(options));
        return CommandLineRun.of(words.toArray());
    }

    /** Names and token types of an object's fields, nested ones included, in order. */
    private static List<String> fields(String json) throws IOException {
        List<String> fields = new ArrayList<>();
        try (JsonParser parser = new JsonFactory().createParser(json)) {
            for (JsonToken token = parser.nextToken(); token != null; token = parser.nextToken()) {
                if (token == JsonToken.FIELD_NAME) {
                    fields.add(parser.currentName() + " " + parser.nextToken());
                }
            }
        }
        return fields;
    }

    @Test
    void theJsonLineHasAllFields() throws IOException {
        CommandLineRun run = run(source("Short", "System.out.println(\"hello\"); Delay.msDelay(100);"), "--json");
        assertThat(run.status()).as(run.err()).isZero();
        String number = "VALUE_NUMBER_(INT|FLOAT)";
        List<String> expected = List.of("program VALUE_STRING", "main VALUE_STRING", "world VALUE_STRING",
                "robot VALUE_STRING",
                "seed VALUE_NUMBER_INT", "outcome VALUE_STRING", "exitStatus VALUE_NUMBER_INT", "simulatedSeconds "
                + number,
                "wallSeconds " + number, "realTimeFactor " + number, "distanceMetres " + number,
                "collisions VALUE_NUMBER_INT", "zones START_ARRAY",
                "finalPose START_OBJECT", "xMetres " + number, "yMetres " + number, "headingDegrees " + number,
                "traceHash VALUE_STRING",
                "contextSwitches VALUE_NUMBER_INT", "physicsSteps VALUE_NUMBER_INT", "backend VALUE_STRING",
                "jdk VALUE_STRING", "error VALUE_NULL");
        List<String> fields = fields(run.lastLine());
        assertThat(fields).hasSameSizeAs(expected);
        for (int i = 0; i < expected.size(); i++) {
            assertThat(fields.get(i)).matches(expected.get(i));
        }
        assertThat(run.lastLine()).contains("\"outcome\":\"exited\",\"exitStatus\":0", "\"world\":\"pen\"",
                "\"seed\":1,");
        assertThat(run.out().lines()).first().isEqualTo("hello");
    }

    @Test
    void theFolderHoldsTheFilesAndTheSummaryIsTheJsonLine() throws IOException {
        CommandLineRun run = run(source("Short", "System.out.println(\"hello\");"), "--json");
        Path out = folder.resolve("out");
        for (String name : new String[] {"summary.json", "trace.jsonl", "signals.csv", "path.svg", "screen.png",
                "robot.svg"}) {
            assertThat(out.resolve(name)).isNotEmptyFile();
        }
        assertThat(out.resolve("console.txt")).hasContent("hello\n");
        assertThat(Files.readString(out.resolve("summary.json")).strip()).isEqualTo(run.lastLine());
        assertThat(out).isDirectoryNotContaining("glob:**.part");
    }

    @Test
    void theConsoleFileHoldsExactlyWhatWasPrinted() throws IOException {
        run(source("Printer", "System.out.print(\"a\\tb\\u00e4\"); System.err.print(\"!\"); System.out.println(); "
                + "System.out.printf(\"%d%%\", 7);"));
        assertThat(Files.readAllBytes(folder.resolve("out/console.txt")))
                .isEqualTo("a\tb\u00e4!\n7%".getBytes(StandardCharsets.UTF_8));
    }

    @Test
    void theHashIsTheOneOfTheTraceFile() throws Exception {
        CommandLineRun run = run(CommandLineRun.program("wallstop/WallStop.java"), "--json");
        byte[] digest = MessageDigest.getInstance("SHA-256")
                .digest(Files.readAllBytes(folder.resolve("out/trace.jsonl")));
        assertThat(run.lastLine()).contains("\"traceHash\":\"" + HexFormat.of().formatHex(digest) + "\"");
    }

    @Test
    void theDefaultFolderIsNamedAfterTheMainClass() throws IOException {
        Path program = source("Defaults", "");
        CommandLineRun run = CommandLineRun.of("run", program);
        assertThat(run.status()).as(run.err()).isZero();
        assertThat(run.out()).contains("files      " + Path.of("build", "simulations", "Defaults"));
        assertThat(Path.of("build", "simulations", "Defaults", "summary.json")).isNotEmptyFile();
    }

    @Test
    void anExceptionIsToldInTheProgramsOwnLinesAndTime() throws IOException {
        CommandLineRun run = run(source("Thrower", "Delay.msDelay(2000);\nint[] none = new int[0];\n"
                + "System.out.println(none[3]);"), "--json");
        assertThat(run.status()).isEqualTo(1);
        assertThat(run.err()).contains("Exception in thread \"main\" after 2.")
                .contains("ArrayIndexOutOfBoundsException: Index 3 out of bounds for length 0")
                .contains("\tat Thrower.main(Thrower.java:7)").contains("run it again: brickless run ");
        assertThat(run.err().lines().filter(line -> line.startsWith("\tat "))).as("only the program's own lines")
                .hasSize(1);
        assertThat(run.lastLine()).contains("\"outcome\":\"failed\",\"exitStatus\":null")
                .contains("\"error\":\"Exception in thread");
    }

    @Test
    void otherThreadsGoOnAfterAnException() throws IOException {
        CommandLineRun run = run(source("Goes", "new Thread(() -> { Delay.msDelay(3000); System.out.println(\"still "
                + "here\"); }).start();\n"
                + "throw new IllegalStateException(\"main is gone\");"), "--json");
        assertThat(run.status()).isEqualTo(1);
        assertThat(run.out()).contains("still here");
        assertThat(run.lastLine()).contains("\"outcome\":\"failed\"");
    }

    @Test
    void anExitStatusOtherThanZeroIsAFailure() throws IOException {
        CommandLineRun run = run(source("Exits", "System.exit(3);"), "--json");
        assertThat(run.status()).isEqualTo(1);
        assertThat(run.lastLine()).contains("\"outcome\":\"exited\",\"exitStatus\":3");
    }

    @Test
    void aDeadlockIsToldWithItsThreads() throws IOException {
        CommandLineRun run = run(source("Locked", "final Object never = new Object();\nsynchronized (never) { "
                + "never.wait(); }"), "--json");
        assertThat(run.status()).isEqualTo(1);
        assertThat(run.lastLine()).contains("\"outcome\":\"deadlock\",\"exitStatus\":null");
        assertThat(run.err()).contains("\"main\" WAITING").contains("Locked.java:6");
    }

    @Test
    void anEndlessLoopEndsAtTheTimeLimit() throws IOException {
        CommandLineRun run = run(source("Endless", "while (true) { }"), "--for", "2s", "--json");
        assertThat(run.status()).isZero();
        assertThat(run.lastLine()).contains("\"outcome\":\"time-limit\",\"exitStatus\":null,\"simulatedSeconds\":2,");
    }

    @Test
    void aMissedGoalIsAFailure() throws IOException {
        CommandLineRun run = run(source("Idle", "Delay.msDelay(500);"), "--until", "zone:goal", "--json");
        assertThat(run.status()).isEqualTo(1);
        assertThat(run.lastLine()).contains("\"outcome\":\"exited\"").contains("\"zones\":[]");
    }

    @Test
    void aReachedGoalEndsTheRun() throws IOException {
        Path world = Files.writeString(folder.resolve("w.svg"),
                "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 3000 1000'>"
                + "<rect data-zone='far' x='1000' y='0' width='500' height='1000'/><g data-robot='robot' "
                + "transform='translate(300 500)'/></svg>");
        CommandLineRun run = run(CommandLineRun.program("explorer/Explorer.java"), "--world", world, "--until",
                "zone:far", "--json");
        assertThat(run.status()).as(run.err()).isZero();
        assertThat(run.lastLine()).contains("\"outcome\":\"goal-reached\"").contains("\"zones\":[\"far\"]")
                .contains("\"xMetres\":1.00");
    }

    @Test
    void exitAsGoalIsMissedAtTheTimeLimit() throws IOException {
        Path sleeper = source("Sleeper", "Delay.msDelay(5000);");
        assertThat(run(sleeper, "--until", "exit", "--for", "1s").status()).isEqualTo(1);
        assertThat(run(sleeper, "--until", "exit", "--for", "10s").status()).isZero();
    }

    @Test
    void keysAreOnlyPressedIfAllowed() throws IOException {
        Path waits = source("Waits", "Button.waitForAnyPress();");
        CommandLineRun pressed = run(waits);
        assertThat(pressed.status()).isZero();
        assertThat(pressed.out()).contains("keys pressed for the program while it waited: ENTER "
                + "(--stimuli to press others, --buttons none").contains("exited");
        CommandLineRun left = run(waits, "--buttons", "none", "--for", "3s", "--json");
        assertThat(left.lastLine()).contains("\"outcome\":\"time-limit\"");
    }

    @Test
    void aKeyThatALoopAsksForIsPressed() throws IOException {
        CommandLineRun run = run(source("Asks",
                "while (Button.ENTER.isUp()) { } while (Button.DOWN.isUp()) { Delay.msDelay(1000); }"));
        assertThat(run.out()).contains("keys pressed for the program while it waited: ENTER, DOWN (")
                .contains("exited with status 0");
    }

    @Test
    void ofTwoThreadsThatWaitForKeysEachGetsSome() throws IOException {
        Path menu = source("Menu", "Thread escape = new Thread(() -> {"
                + " while (Button.waitForAnyPress() != Button.ID_ESCAPE) { } });"
                + " escape.setDaemon(true); escape.start(); while (Button.waitForAnyPress() != Button.ID_LEFT) { }");
        assertThat(run(menu, "--until", "exit").status()).isZero();
    }

    @Test
    void aWindowIsRefusedWithAReason() throws IOException {
        for (String statement : List.of("java.awt.EventQueue.invokeLater(() -> { });", "new javax.swing.JFrame();")) {
            CommandLineRun run = run(source("Window", statement));
            assertThat(run.status()).isEqualTo(1);
            assertThat(run.err()).contains(
                    "java.awt.HeadlessException: a brick has no windows, this part of the program is for a PC");
        }
    }

    @Test
    void theCommandThatRepeatsAFailureQuotesBlanks() throws IOException {
        Path program = Files.createDirectories(folder.resolve("my robot")).resolve("Fails.java");
        Files.writeString(program,
                "class Fails { public static void main(String[] a) { throw new IllegalStateException(); } }");
        assertThat(run(program).err()).contains("run it again: brickless run '" + program + "'");
    }

    @Test
    void theSummaryTellsTheFittedRobotAndTheFolder() {
        CommandLineRun run = run(CommandLineRun.program("wallstop/WallStop.java"));
        assertThat(run.out()).contains("robot fitted to the program: ", "left wheel on B (large motor, 56.0 mm)",
                "ev3-ultrasonic on S4", "outcome    exited with status 0",
                "files      " + folder.resolve("out"));
    }
}
