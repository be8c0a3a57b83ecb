package brickless.cli;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.trace.JsonFields;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** {@code brickless view} as a process of its own, told to end as Ctrl-C does. */
@Timeout(180)
class ViewCommandTest {
    @TempDir Path folder;

    /** A running command. */
    private final class Command implements AutoCloseable {
        private final Process process;
        private final BufferedReader out;
        private final HttpClient client = HttpClient.newHttpClient();
        private final URI address;

        Command(String... words) throws IOException {
            List<String> line = new ArrayList<>(
                    List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                            "-Djava.awt.headless=true", "-cp", System.getProperty("java.class.path"),
                            "brickless.cli.Main"));
            line.addAll(List.of(words));
            line.addAll(List.of("--no-browser", "--json", "--out", folder.resolve("out").toString()));
            process = new ProcessBuilder(line).redirectErrorStream(true).directory(folder.toFile()).start();
            out = new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
            String first = out.readLine();
            assertThat(first).startsWith("open http://127.0.0.1:").endsWith("/ (Ctrl-C ends)");
            address = URI.create(first.split(" ")[1]);
        }

        /** Watches until a state fulfils a condition. */
        JsonFields watch(Predicate<JsonFields> condition) throws IOException, InterruptedException {
            HttpResponse<InputStream> answer = client.send(HttpRequest.newBuilder(address.resolve("events")).build(),
                    HttpResponse.BodyHandlers.ofInputStream());
            try (BufferedReader lines = new BufferedReader(
                    new InputStreamReader(answer.body(), StandardCharsets.UTF_8))) {
                String last = "";
                for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                    if (last.equals("event: state") && condition.test(JsonFields.parse(line.substring(6)))) {
                        return JsonFields.parse(line.substring(6));
                    }
                    last = line;
                }
            }
            throw new AssertionError("the stream ended");
        }

        void command(String body) throws IOException, InterruptedException {
            HttpResponse<String> answer = client.send(HttpRequest.newBuilder(address.resolve("do"))
                    .header("Content-Type", "application/json")
                    .POST(HttpRequest.BodyPublishers.ofString(body.replace('\'', '"'))).build(),
                    HttpResponse.BodyHandlers.ofString());
            assertThat(answer.statusCode()).as(answer.body()).isEqualTo(204);
        }

        /** Tells the process to end; returns the last line that it printed. */
        JsonFields end() throws IOException, InterruptedException {
            process.toHandle().destroy();
            String last = "";
            for (String line = out.readLine(); line != null; line = out.readLine()) {
                last = line;
            }
            assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();
            return JsonFields.parse(last);
        }

        @Override
        public void close() {
            process.destroyForcibly();
        }
    }

    @Test
    void theSavedFileSaysHowToRepeatTheSessionHeadless() throws Exception {
        String program = CommandLineRun.program("square/Square.java").toString();
        String hash;
        try (Command view = new Command("view", program, "--world", "maze", "--seed", "5", "--speed", "4")) {
            view.watch(state -> state.number("t") > 0.4);
            view.command("{'do':'hold','what':'key ENTER','down':true}");
            view.watch(state -> state.number("t") > 0.8);
            view.command("{'do':'hold','what':'key ENTER','down':false}");
            view.command("{'do':'touch','stimulus':'battery 7.4V'}");
            view.watch(state -> state.number("t") > 1.2);
            JsonFields summary = view.end();
            assertThat(summary.text("outcome")).isEqualTo("time-limit");
            hash = summary.text("traceHash");
        }
        Path stimuli = folder.resolve("out/stimuli.txt");
        List<String> lines = Files.readAllLines(stimuli);
        assertThat(lines).anyMatch(line -> line.endsWith(" hold key ENTER"))
                .anyMatch(line -> line.endsWith(" battery 7.4V"));
        assertThat(folder.resolve("out/report.html")).isNotEmptyFile();
        String command = lines.get(1);
        assertThat(command).startsWith("# brickless run " + program)
                .contains("--world maze", "--seed 5", "--stimuli stimuli.txt", "--buttons none", "--attended");
        List<Object> words = new ArrayList<>(
                Arrays.asList(command.replace("--stimuli stimuli.txt", "--stimuli " + stimuli).split(" ")).subList(2,
                command.split(" ").length));
        words.addAll(List.of("--json", "--out", folder.resolve("again")));
        CommandLineRun again = CommandLineRun.of(words.toArray());
        assertThat(JsonFields.parse(again.lastLine()).text("traceHash")).as(command).isEqualTo(hash);
    }

    @Test
    void aWatchedRunHasTheLimitsAndTheTraceOfARun() throws Exception {
        String program = CommandLineRun.program("square/Square.java").toString();
        CommandLineRun headless = CommandLineRun.of("run", program, "--for", "2s", "--json", "--out",
                folder.resolve("headless"));
        try (Command view = new Command("run", "--view", program, "--for", "2s", "--speed", "max")) {
            JsonFields ended = view.watch(state -> state.has("ended")).object("ended");
            assertThat(ended.text("hash")).isEqualTo(JsonFields.parse(headless.lastLine()).text("traceHash"));
            assertThat(view.end().text("traceHash")).isEqualTo(ended.text("hash"));
        }
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "--speed 0 | '0' is no speed; allowed: 0.1 to 100, max",
        "--speed fast | 'fast' is no speed",
        "--port 65536 | a port is 0 to 65535",
        "--token short | a token is 16 to 100 letters",
        "--world nowhere | nowhere: no such world"})
    void badOptionsAreExplained(String option, String reason) {
        CommandLineRun run = CommandLineRun.of("view", CommandLineRun.program("square/Square.java"), "--no-browser",
                option.split(" ")[0], option.split(" ")[1]);
        assertThat(run.status()).isEqualTo(2);
        assertThat(run.err()).contains(reason).hasLineCount(1);
    }

    @Test
    void aProgramThatDoesNotCompileOpensNoView() throws IOException {
        Path broken = Files.writeString(folder.resolve("Broken.java"), "public class Broken { oops }");
        CommandLineRun run = CommandLineRun.of("view", broken, "--no-browser");
        assertThat(run.status()).isEqualTo(2);
        assertThat(run.err()).contains("Broken.java:1: error:");
    }

    @Test
    void onAnAttendedBrickAnExceptionWaitsForAKey() throws IOException {
        Path thrower = Files.writeString(folder.resolve("Thrower.java"),
                "public class Thrower { public static void main(String[] args) { throw new "
                + "IllegalStateException(\"oh\"); } }");
        Path key = Files.writeString(folder.resolve("key.txt"), "2s press ESCAPE 100ms\n");
        JsonFields alone = summary("run", thrower, "--for", "5s");
        JsonFields watched = summary("run", thrower, "--for", "5s", "--attended", "--buttons", "none");
        JsonFields answered = summary("run", thrower, "--for", "5s", "--attended", "--buttons", "none",
                "--stimuli", key);
        assertThat(alone.number("simulatedSeconds")).isLessThan(1);
        assertThat(watched.number("simulatedSeconds")).isEqualTo(5);
        assertThat(answered.number("simulatedSeconds")).isBetween(2.0, 3.0);
        assertThat(List.of(alone.text("outcome"), watched.text("outcome"), answered.text("outcome")))
                .containsOnly("failed");
    }

    private JsonFields summary(Object... words) {
        List<Object> all = new ArrayList<>(List.of(words));
        all.addAll(List.of("--json", "--out", folder.resolve("run")));
        return JsonFields.parse(CommandLineRun.of(all.toArray()).lastLine());
    }

    @Test
    void theBrowserIsOpenedAsTheSystemDoes() {
        assertThat(DesktopBrowser.opener("mac os x", false)).contains(List.of("open"));
        assertThat(DesktopBrowser.opener("windows 11", false))
                .contains(List.of("rundll32", "url.dll,FileProtocolHandler"));
        assertThat(DesktopBrowser.opener("linux", true)).contains(List.of("xdg-open"));
        assertThat(DesktopBrowser.opener("linux", false)).isEmpty();
    }
}
