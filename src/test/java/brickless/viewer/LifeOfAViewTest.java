package brickless.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import brickless.simulation.SetupException;
import brickless.trace.Decimals;
import brickless.trace.JsonFields;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import programs.robots.KeyWatch;
import programs.robots.TwoPollers;

/** Viewers that come, go, sleep and hold things, and the end of a view. */
@Timeout(120)
class LifeOfAViewTest {
    @TempDir Path folder;

    private static List<String> threads() {
        return Thread.getAllStackTraces().keySet().stream().filter(Thread::isAlive).map(Thread::getName)
                .filter(name -> name.startsWith("brickless") || name.startsWith("HTTP-Dispatcher")).sorted().toList();
    }

    @Test
    void aViewThatIsClosedLeavesNoThreadsAndTellsItsViewers() throws Exception {
        List<String> before = threads();
        try (Visit visit = Visit.to(TwoPollers.class, Speed.MAX); Socket sleeper = sleeper(visit);
                Spectator spectator = Spectator.of(visit.view)) {
            spectator.awaitTime(60);
            assertThat(threads()).contains("brickless-view-driver", "brickless-view-files", "brickless-view-http",
                    "brickless-run");
            visit.view.close();
            assertThat(threads()).isEqualTo(before);
            JsonFields last = spectator.await("state", state -> state.has("ended")).fields();
            assertThat(last.object("ended").text("outcome")).isEqualTo("time-limit");
            spectator.awaitEnd();
            assertThatThrownBy(() -> visit.get("")).isInstanceOf(IOException.class);
        }
    }

    @Test
    void aViewThatNobodyWatchedNeverRan() throws Exception {
        Path out = folder.resolve("out");
        try (Visit visit = Visit.to(TwoPollers.class, Visit.settings().out(Optional.of(out)).build(), 1)) {
            visit.view.close();
            assertThat(visit.view.awaitEnd()).isEmpty();
        }
        try (var files = Files.list(out)) {
            assertThat(files).isEmpty();
        }
    }

    @Test
    void theFilesOfTheRunAndWhatWasTouchedAreWritten() throws Exception {
        Path out = folder.resolve("out");
        try (Visit visit = Visit.to(KeyWatch.class, Visit.settings().out(Optional.of(out)).build(), 1);
                Spectator spectator = Spectator.of(visit.view)) {
            visit.command("{'do':'touch','stimulus':'clap 80dB'}");
            spectator.awaitEvent("clap");
            String hash = visit.end().traceHash();
            assertThat(out).isDirectoryContaining("glob:**/report.html").isDirectoryContaining("glob:**/trace.jsonl");
            String stimuli = Files.readString(out.resolve("stimuli.txt"));
            assertThat(visit.repeat(stimuli, Visit.settings().build()).traceHash()).isEqualTo(hash);
        }
    }

    @Test
    void whatAViewerHoldsIsLetGoWhenItGoes() throws Exception {
        try (Visit visit = Visit.to(KeyWatch.class, 1); Spectator stays = Spectator.of(visit.view)) {
            try (Spectator goes = Spectator.of(visit.view)) {
                long viewer = goes.await("begin").fields().integer("viewer");
                visit.command("{'do':'hold','what':'key ENTER','down':true,'viewer':" + viewer + "}");
                stays.awaitEvent("\"key\":\"ENTER\",\"down\":true");
            }
            stays.awaitEvent("\"key\":\"ENTER\",\"down\":false");
        }
    }

    @Test
    void aTouchMovesAHeldRunOnByOneStepAndNothingElseDoes() throws Exception {
        try (Visit visit = Visit.to(KeyWatch.class, 1); Spectator stays = Spectator.of(visit.view)) {
            stays.awaitTime(0.05);
            visit.command("{'do':'pause'}");
            long held = stays.await("state", state -> !state.flag("running")).fields().nanos("t");
            try (Spectator goes = Spectator.of(visit.view)) {
                goes.await("begin");
            }
            visit.command("{'do':'hold','what':'key LEFT','down':true}");
            visit.command("{'do':'hold','what':'key LEFT','down':true}");
            visit.command("{'do':'hold','what':'push S1','down':false}");
            assertThat(stays.await("state", state -> state.integer("touches") == 1).fields().nanos("t"))
                    .isEqualTo(held + 2_000_000);
            visit.command("{'do':'hold','what':'key LEFT','down':false}");
            assertThat(stays.await("state", state -> state.integer("touches") == 2).fields().nanos("t"))
                    .isEqualTo(held + 4_000_000);
        }
    }

    @Test
    void whatTwoViewersHoldIsHeldUntilBothLetGo() throws Exception {
        try (Visit visit = Visit.to(KeyWatch.class, 1); Spectator spectator = Spectator.of(visit.view)) {
            visit.command("{'do':'hold','what':'key ENTER','down':true,'viewer':11}");
            visit.command("{'do':'hold','what':'key ENTER','down':true,'viewer':12}");
            spectator.awaitEvent("\"key\":\"ENTER\",\"down\":true");
            visit.command("{'do':'hold','what':'key ENTER','down':false,'viewer':11}");
            assertThat(visit.get("stimuli").body()).contains("hold key ENTER").doesNotContain("release");
            visit.command("{'do':'hold','what':'key ENTER','down':false,'viewer':12}");
            spectator.awaitEvent("\"key\":\"ENTER\",\"down\":false");
        }
    }

    @Test
    void holdsOfNobodyEndWithTheLastViewer() throws Exception {
        try (Visit visit = Visit.to(KeyWatch.class, 1)) {
            try (Spectator only = Spectator.of(visit.view)) {
                visit.command("{'do':'hold','what':'key LEFT','down':true}");
                only.awaitEvent("\"key\":\"LEFT\",\"down\":true");
            }
            String file = "";
            while (!file.contains("release key LEFT")) {
                file = visit.get("stimuli").body();
            }
        }
    }

    /** A viewer that does not read for a while. */
    private static Socket sleeper(Visit visit) throws IOException {
        Socket socket = new Socket();
        socket.setReceiveBufferSize(16_384);
        socket.setSoTimeout(40_000);
        socket.connect(new InetSocketAddress("127.0.0.1", visit.view.address().getPort()));
        socket.getOutputStream()
                .write(("GET " + visit.view.address().getPath() + "events HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n")
                .getBytes(StandardCharsets.US_ASCII));
        return socket;
    }

    @Test
    void aViewerThatSleepsDelaysNobodyAndCatchesUpWhenItWakes() throws Exception {
        try (Visit visit = Visit.to(TwoPollers.class, Speed.MAX); Socket sleeper = sleeper(visit);
                Spectator awake = Spectator.of(visit.view)) {
            double asleep = awake.awaitTime(60).number("t");
            awake.await("frame", frame -> frame.number("t") > asleep + 60);
            visit.command("{'do':'pause'}");
            double held = awake.await("state", state -> !state.flag("running")).fields().number("t");
            BufferedReader in = new BufferedReader(
                    new InputStreamReader(sleeper.getInputStream(), StandardCharsets.UTF_8));
            String newest = "data: {\"t\":" + Decimals.text(held, 6) + ",\"session\":1,\"running\":false";
            int frames = 0;
            String line = in.readLine();
            while (!line.startsWith(newest)) {
                frames += line.equals("event: frame") ? 1 : 0;
                line = in.readLine();
                assertThat(line).as("line of a stream that goes on").isNotNull();
            }
            long shown = awake.messages().stream().filter(message -> message.name().equals("frame")).count();
            assertThat(frames).as("frames while asleep, of %d", shown).isLessThan((int) shown);
        }
    }

    @Test
    void aRestartedServerHasTheSameAddressIfPortAndTokenAreGiven() throws Exception {
        String token = "abcdefghijklmnop-_0123456789";
        String address;
        int port;
        try (LiveView view = open(0, token)) {
            address = view.address().toString();
            port = view.address().getPort();
            try (Spectator spectator = Spectator.of(view)) {
                spectator.await("begin");
            }
        }
        try (LiveView again = open(port, token); Spectator spectator = Spectator.of(again)) {
            assertThat(again.address()).hasToString(address);
            assertThat(spectator.await("begin").fields().integer("session")).isEqualTo(1);
        }
    }

    private static LiveView open(int port, String token) {
        return LiveView.open(seed -> Visit.prepared(TwoPollers.class, Visit.settings().build(), seed),
                ViewOptions.of(port, Optional.of(token), 1));
    }

    @Test
    void whatCannotBePreparedOpensNothing() {
        assertThatThrownBy(() -> LiveView.open(seed -> {
            throw new SetupException("no such program");
        }, ViewOptions.of(0, Optional.empty(), 1))).isInstanceOf(SetupException.class).hasMessage("no such program");
    }
}
