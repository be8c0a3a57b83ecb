package brickless.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.program.Program;
import brickless.program.ProgramException;
import brickless.program.ProgramFiles;
import brickless.program.ProgramFinder;
import brickless.simulation.SetupException;
import brickless.simulation.SimulationSettings;
import brickless.trace.JsonFields;
import java.io.IOException;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import programs.robots.TwoPollers;

/** Restarts of a live view: the same again, with another seed, or with a program that was edited meanwhile. */
@Timeout(120)
class RestartTest {
    @TempDir Path folder;
    private Path source;
    private volatile RunSource.Prepared latest;

    @BeforeEach
    void writeProgram() throws IOException {
        source = folder.resolve("Talk.java");
        write("first");
    }

    private void write(String text) throws IOException {
        Files.writeString(source, "public class Talk { public static void main(String[] args) throws Exception { "
                + "System.out.println(\"" + text + "\"); Thread.sleep(1000000); } }\n");
    }

    /** The program in the folder, as the command line finds it. */
    private RunSource.Prepared prepare(OptionalLong seed) {
        try {
            Program program = new ProgramFinder(folder, List.of(), Optional.empty()).find("Talk.java");
            SimulationSettings settings = Visit.settings().seed(seed.orElse(1))
                    .out(Optional.of(folder.resolve("out"))).build();
            latest = new RunSource.Prepared(program, settings, ProgramFiles.of(folder, program),
                    limit -> "brickless run");
            return latest;
        } catch (ProgramException e) {
            throw new SetupException(e.getMessage());
        }
    }

    private Visit visit() {
        return Visit.to(this::prepare, 1);
    }

    @Test
    void aRestartBeginsTheSameAgainForAllViewers() throws Exception {
        try (Visit visit = Visit.to(TwoPollers.class, 1); Spectator one = Spectator.of(visit.view);
                Spectator two = Spectator.of(visit.view)) {
            one.awaitTime(0.3);
            visit.command("{'do':'touch','stimulus':'clap 80dB'}");
            visit.command("{'do':'restart'}");
            for (Spectator viewer : List.of(one, two)) {
                JsonFields begin = viewer.await("begin", fields -> fields.integer("session") == 2).fields();
                assertThat(begin.integer("seed")).isEqualTo(1);
                assertThat(viewer.await("state").fields().integer("touches")).isZero();
            }
            visit.command("{'do':'restart','seed':7}");
            assertThat(one.await("begin", fields -> fields.integer("session") == 3).fields().integer("seed"))
                    .isEqualTo(7);
            visit.command("{'do':'restart'}");
            assertThat(one.await("begin", fields -> fields.integer("session") == 4).fields().integer("seed"))
                    .as("the last one").isEqualTo(7);
            one.awaitTime(0.2);
        }
    }

    @Test
    void anEditedProgramIsOfferedAndRunsAfterARestart() throws Exception {
        try (Visit visit = visit(); Spectator spectator = Spectator.of(visit.view)) {
            spectator.awaitEvent("\"text\":\"first\"");
            write("second");
            JsonFields state = spectator.await("state", fields -> !fields.texts("changed").isEmpty()).fields();
            assertThat(state.texts("changed")).containsExactly(source.toString());
            visit.command("{'do':'restart'}");
            spectator.await("begin", begin -> begin.integer("session") == 2);
            assertThat(spectator.await("state").fields().texts("changed")).isEmpty();
            spectator.awaitEvent("\"text\":\"second\"");
        }
        assertThat(folder.resolve("out/console.txt")).as("of two robots").hasContent("second\nsecond\n");
    }

    @Test
    void aChangeThatIsTakenBackIsNoChange() throws Exception {
        try (Visit visit = visit(); Spectator spectator = Spectator.of(visit.view)) {
            write("other");
            spectator.await("state", fields -> !fields.texts("changed").isEmpty());
            write("first");
            spectator.await("state", fields -> fields.texts("changed").isEmpty());
        }
    }

    @Test
    void aProgramThatDoesNotCompileLeavesTheOldRunGoing() throws Exception {
        try (Visit visit = visit(); Spectator spectator = Spectator.of(visit.view)) {
            spectator.awaitEvent("\"text\":\"first\"");
            Files.writeString(source, "public class Talk { public static void main(String[] args) { oops } }\n");
            HttpResponse<String> answer = visit.post("{\"do\":\"restart\"}");
            assertThat(answer.statusCode()).isEqualTo(400);
            assertThat(JsonFields.parse(answer.body()).text("error")).contains("Talk.java:1: error:");
            JsonFields state = spectator.await("state", fields -> fields.has("message")).fields();
            assertThat(state.text("message")).contains("Talk.java:1: error:");
            assertThat(state.integer("session")).isEqualTo(1);
            spectator.awaitTime(state.number("t") + 0.2);
            write("repaired");
            visit.command("{'do':'restart'}");
            spectator.awaitEvent("\"text\":\"repaired\"");
            assertThat(spectator.await("state").fields().has("message")).isFalse();
        }
    }

    @Test
    void aRunThatEndedIsNotTouchedButRestarted() throws Exception {
        Files.writeString(source, "public class Talk { public static void main(String[] args) { System.exit(3); } }\n");
        try (Visit visit = visit(); Spectator spectator = Spectator.of(visit.view)) {
            JsonFields ended = spectator.await("state", state -> state.has("ended")).fields();
            assertThat(ended.flag("running")).isFalse();
            assertThat(ended.object("ended").text("outcome")).isEqualTo("exited");
            assertThat(ended.object("ended").integer("exitStatus")).isEqualTo(3);
            for (String command : List.of("{'do':'play'}", "{'do':'step'}", "{'do':'touch','stimulus':'clap 80dB'}",
                    "{'do':'hold','what':'key ENTER','down':true}")) {
                assertThat(visit.post(command.replace('\'', '"')).body()).as(command)
                        .contains("the run has ended; restart it");
            }
            visit.command("{'do':'restart'}");
            spectator.await("state", state -> state.integer("session") == 2 && state.has("ended"));
        }
    }

    @Test
    void temporaryClassesAreRemovedWithTheirRun() throws Exception {
        Path first;
        try (Visit visit = visit(); Spectator spectator = Spectator.of(visit.view)) {
            first = classes();
            visit.command("{'do':'restart'}");
            assertThat(first).doesNotExist();
            spectator.await("begin", begin -> begin.integer("session") == 2);
            assertThat(classes()).isDirectory();
        }
        assertThat(latest.program().temporary().orElseThrow()).doesNotExist();
    }

    private Path classes() {
        return latest.program().temporary().orElseThrow();
    }
}
