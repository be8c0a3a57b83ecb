package brickless.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import brickless.simulation.SetupException;
import brickless.trace.JsonFields;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.NetworkInterface;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import programs.robots.TwoPollers;

/** Who and what the server of the live view lets in. */
@Timeout(60)
class ViewServerTest {
    private static Visit visit;

    @BeforeAll
    static void open() {
        visit = Visit.to(TwoPollers.class, 1);
    }

    @AfterAll
    static void close() {
        visit.close();
    }

    private static URI elsewhere(String path) {
        return visit.view.address().resolve(path);
    }

    private static HttpRequest.Builder json(String body) {
        return HttpRequest.newBuilder(visit.address("do")).header("Content-Type", "application/json")
                .POST(HttpRequest.BodyPublishers.ofString(body));
    }

    private static void assertRefused(HttpResponse<String> answer, int status) {
        assertThat(answer.statusCode()).isEqualTo(status);
        assertThat(JsonFields.parse(answer.body()).text("error")).isNotBlank();
    }

    /** A request as it is, for what no client would send. */
    private static String raw(String head) throws IOException {
        try (Socket socket = new Socket("127.0.0.1", visit.view.address().getPort())) {
            OutputStream out = socket.getOutputStream();
            out.write((head + "\r\nConnection: close\r\n\r\n").getBytes(StandardCharsets.US_ASCII));
            out.flush();
            String line = new BufferedReader(new InputStreamReader(socket.getInputStream(), StandardCharsets.US_ASCII))
                    .readLine();
            return line == null ? "closed" : line;
        }
    }

    @Test
    void theAddressHoldsATokenOf128RandomBits() {
        assertThat(visit.view.address().getHost()).isEqualTo("127.0.0.1");
        assertThat(visit.view.address().getPath()).matches("/[A-Za-z0-9_-]{22}/");
        assertThat(ViewOptions.of(0, Optional.empty(), 1).token())
                .isNotEqualTo(ViewOptions.of(0, Optional.empty(), 1).token());
    }

    @Test
    void thePageIsServedAndNothingMayKeepOrFrameIt() throws Exception {
        HttpResponse<String> page = visit.get("");
        assertThat(page.statusCode()).isEqualTo(200);
        assertThat(page.headers().firstValue("Content-Type")).contains("text/html; charset=utf-8");
        assertThat(page.headers().firstValue("Cache-Control")).contains("no-store");
        assertThat(page.headers().firstValue("X-Frame-Options")).contains("DENY");
        assertThat(page.headers().firstValue("Access-Control-Allow-Origin")).isEmpty();
        assertThat(page.body()).contains("<html", "Content-Security-Policy");
    }

    @Test
    void theAddressWithoutItsSlashLeadsToThePage() throws Exception {
        String address = visit.view.address().toString();
        HttpResponse<String> answer =
                visit.send(HttpRequest.newBuilder(URI.create(address.substring(0, address.length() - 1))));
        assertThat(answer.statusCode()).isEqualTo(301);
        assertThat(answer.headers().firstValue("Location")).contains(visit.view.address().getPath());
    }

    @ParameterizedTest
    @ValueSource(strings = {"/", "/x/", "/0123456789abcdefghijkl/", "/0123456789abcdefghijkl/events",
            "/favicon.ico", "/%2e%2e/"})
    void whoDoesNotKnowTheTokenIsRefused(String path) throws Exception {
        assertRefused(visit.send(HttpRequest.newBuilder(elsewhere(path))), 403);
    }

    @ParameterizedTest
    @ValueSource(strings = {"nothing", "../events", "../../etc/passwd", "%2e%2e/%2e%2e/etc/passwd",
            "report/theme.css", "events/"})
    void thereAreNoOtherPages(String resource) throws Exception {
        assertThat(raw("GET " + visit.view.address().getPath() + resource + " HTTP/1.1\r\nHost: 127.0.0.1"))
                .contains(" 404 ");
    }

    @Test
    void requestsOfOtherPagesAreRefused() throws Exception {
        HttpRequest.Builder foreign = json("{\"do\":\"pause\"}").header("Origin", "http://evil.example");
        assertRefused(visit.send(foreign), 403);
        assertRefused(visit.send(json("{\"do\":\"pause\"}").header("Origin", "null")), 403);
        assertRefused(visit.send(json("{\"do\":\"pause\"}").header("Origin", "http://127.0.0.1:1")), 403);
        String own = "http://localhost:" + visit.view.address().getPort();
        assertThat(visit.send(json("{\"do\":\"speed\",\"value\":1}").header("Origin", own)).statusCode())
                .isEqualTo(204);
    }

    @Test
    void requestsForOtherHostsAreRefused() throws IOException {
        String path = visit.view.address().getPath();
        int port = visit.view.address().getPort();
        assertThat(raw("GET " + path + " HTTP/1.1\r\nHost: evil.example")).contains(" 403 ");
        assertThat(raw("GET " + path + " HTTP/1.1\r\nHost: evil.example:" + port)).contains(" 403 ");
        assertThat(raw("GET " + path + " HTTP/1.1\r\nHost: localhost:1")).contains(" 403 ");
        assertThat(raw("GET " + path + " HTTP/1.1\r\nHost: localhost:" + port)).contains(" 200 ");
        assertThat(raw("GET " + path + " HTTP/1.1\r\nHost: 127.0.0.1\r\nHost: evil.example")).doesNotContain(" 200 ");
        assertThat(raw("GET " + path + " HTTP/1.0")).contains(" 403 ");
    }

    @ParameterizedTest
    @ValueSource(strings = {"GET http://127.0.0.1 HTTP/1.1", "GET * HTTP/1.1", "GET foo:bar HTTP/1.1", "NONSENSE",
            "GET // HTTP/1.1", "GET / HTTP/9.9"})
    void oddRequestsDoNoHarm(String line) throws Exception {
        assertThat(raw(line + "\r\nHost: 127.0.0.1")).doesNotContain(" 200 ");
        assertThat(visit.get("").statusCode()).isEqualTo(200);
    }

    @Test
    void theServerListensOnThisMachineOnly() throws Exception {
        for (NetworkInterface network : NetworkInterface.networkInterfaces().toList()) {
            for (InetAddress address : network.inetAddresses().filter(a -> !a.isLoopbackAddress()).toList()) {
                assertThatThrownBy(() -> new Socket(address, visit.view.address().getPort()).close())
                        .isInstanceOf(IOException.class);
            }
        }
    }

    @Test
    void bodiesOverTheLimitAreRefused() throws Exception {
        String longest = "{\"do\":\"speed\",\"value\":1" + " ".repeat(4_096 - 24) + "}";
        assertThat(longest).hasSize(4_096);
        assertThat(visit.post(longest).statusCode()).isEqualTo(204);
        assertRefused(visit.post(longest + " "), 413);
        assertRefused(visit.post(" ".repeat(60_000)), 413);
    }

    @Test
    void commandsAreJson() throws Exception {
        assertRefused(visit.send(HttpRequest.newBuilder(visit.address("do")).header("Content-Type", "text/plain")
                .POST(HttpRequest.BodyPublishers.ofString("{\"do\":\"pause\"}"))), 415);
        assertRefused(visit.send(HttpRequest.newBuilder(visit.address("do")).POST(HttpRequest.BodyPublishers.noBody())),
                415);
        assertThat(visit.send(HttpRequest.newBuilder(visit.address("do"))
                .header("Content-Type", "Application/JSON; charset=utf-8")
                .POST(HttpRequest.BodyPublishers.ofString("{\"do\":\"speed\",\"value\":1}"))).statusCode())
                .isEqualTo(204);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '~', value = {
        "'' | is no JSON object",
        "{'do' | is cut off",
        "{'do':'pause'}{} | more than one",
        "[] | is no JSON object",
        "{} | \"do\" is missing",
        "{'do':7} | \"do\" is not a string",
        "{'do':'explode'} | 'explode' is nothing to do; allowed: pause, play, step",
        "{'do':'step','millis':0} | \"millis\" is 1 to 60000",
        "{'do':'step','millis':1e99} | \"millis\" is not a whole number",
        "{'do':'speed','value':0} | a speed is 0.1 to 100",
        "{'do':'speed','value':'fast'} | a speed is 0.1 to 100",
        "{'do':'speed'} | \"value\" is missing",
        "{'do':'restart','seed':'x'} | \"seed\" is not a whole number",
        "{'do':'touch','stimulus':'dance'} | unknown stimulus 'dance'",
        "{'do':'touch','stimulus':'clap 80dB\\n1s clap 80dB'} | is one line",
        "{'do':'touch','stimulus':'# nothing'} | is one line",
        "{'do':'touch','stimulus':''} | is one line",
        "{'do':'touch','stimulus':'remove piano'} | there is nothing movable named piano",
        "{'do':'touch','stimulus':'press ENTER 1s on roof'} | no robot named roof",
        "{'do':'hold','robot':'roof','what':'key ENTER','down':true} | no robot named roof",
        "{'do':'hold','robot':'left','what':'nose','down':true} | needs what to hold",
        "{'do':'hold','robot':'left','what':'key ENTER','down':1} | \"down\" is not"})
    void badCommandsAreExplained(String body, String reason) throws Exception {
        HttpResponse<String> answer = visit.post(body.equals("''") ? "" : body.replace('\'', '"'));
        assertRefused(answer, 400);
        assertThat(JsonFields.parse(answer.body()).text("error")).contains(reason);
    }

    @Test
    void everyAddressHasItsMethod() throws Exception {
        HttpResponse<String> answer = visit.get("do");
        assertRefused(answer, 405);
        assertThat(answer.headers().firstValue("Allow")).contains("POST");
        for (String resource : new String[] {"", "events", "stimuli"}) {
            assertRefused(visit.send(HttpRequest.newBuilder(visit.address(resource))
                    .POST(HttpRequest.BodyPublishers.noBody())), 405);
        }
    }

    @Test
    void thereIsRoomForSixteenViewersAndForMoreWhenSomeGo() throws Exception {
        List<Spectator> viewers = new ArrayList<>();
        try {
            for (int i = 0; i < ViewServer.MOST_VIEWERS; i++) {
                viewers.add(Spectator.of(visit.view));
            }
            assertRefused(visit.get("events"), 503);
            viewers.remove(0).close();
            viewers.get(0).await("begin");
            viewers.add(next());
            viewers.get(viewers.size() - 1).await("begin");
        } finally {
            for (Spectator viewer : viewers) {
                viewer.close();
            }
        }
    }

    /** A seat is free as soon as the server notices that somebody has gone. */
    private static Spectator next() throws Exception {
        while (true) {
            try {
                return Spectator.of(visit.view);
            } catch (IOException full) {
                assertThat(full).hasMessageContaining("503");
            }
        }
    }

    @Test
    void aPortThatIsTakenIsNamed() {
        int port = visit.view.address().getPort();
        assertThatThrownBy(() -> LiveView.open(seed -> Visit.prepared(TwoPollers.class, Visit.settings().build(), seed),
                ViewOptions.of(port, Optional.empty(), 1))).isInstanceOf(SetupException.class)
                .hasMessageContaining("port " + port);
    }

    @ParameterizedTest
    @ValueSource(strings = {"short", "0123456789abcde/", "with space in the token", "0123456789abcde?"})
    void tokensThatAreTooShortOrOddAreRefused(String token) {
        assertThatThrownBy(() -> ViewOptions.of(0, Optional.of(token), 1)).isInstanceOf(IllegalArgumentException.class);
    }
}
