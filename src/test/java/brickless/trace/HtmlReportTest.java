package brickless.trace;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.util.Base64;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.zip.InflaterInputStream;
import org.junit.jupiter.api.Test;

/**
 * The page as text: what is inside, what is escaped, how large it gets. What it does in a browser is
 * {@code ReportPageTest}'s.
 */
class HtmlReportTest {
    private static final String NASTY = "</script><script>alert(1)</script><!-- \u2028 %DATA% %SCRIPT%";
    private static final Pattern DATA = Pattern.compile("id=\"run\">([^<]*)</script>");

    private static String page(ReportRecording recording, ReportScene scene) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        HtmlReport.write(out, recording, scene, Optional.empty());
        return out.toString(StandardCharsets.UTF_8);
    }

    private static JsonFields data(String page) throws IOException {
        Matcher data = DATA.matcher(page);
        assertThat(data.find()).isTrue();
        byte[] packed = Base64.getDecoder().decode(data.group(1));
        return JsonFields.parse(new String(new InflaterInputStream(new ByteArrayInputStream(packed)).readAllBytes(),
                StandardCharsets.UTF_8));
    }

    private static ReportRecording recording(TraceEvent... events) {
        ReportRecording recording = new ReportRecording();
        SyntheticRun run = new SyntheticRun(recording);
        run.standing(0);
        for (int i = 0; i < events.length; i++) {
            run.at((i + 1) * 1_000_000_000L, events[i]);
        }
        return recording;
    }

    @Test
    void everyKindOfEventIsInside() throws IOException {
        TraceEvent[] events = TraceReaderTest.everyKindOfEvent().toArray(TraceEvent[]::new);
        assertThat(data(page(recording(events), SyntheticRun.scene())).objects("events"))
                .extracting(event -> event.text("type"))
                .containsExactly(TraceReaderTest.everyKindOfEvent().stream().map(TraceEvent::type)
                        .toArray(String[]::new));
    }

    @Test
    void whatTheProgramPrintsIsNeverMarkup() throws IOException {
        String page = page(recording(new TraceEvent.PrintEvent(NASTY, false)), SyntheticRun.scene());
        assertThat(page).doesNotContain("alert(1)").doesNotContain("%DATA%").doesNotContain("%SCRIPT%");
        assertThat(page.split("<script", -1)).hasSize(3);
        assertThat(data(page).objects("events").get(0).text("text")).isEqualTo(NASTY);
    }

    @Test
    void theTitleIsEscaped() throws IOException {
        ReportRecording recording = new ReportRecording();
        recording.header(new TraceHeader("a<b>&\"c", "w", List.of(), 1, -1, false, 1, 1));
        assertThat(page(recording, SyntheticRun.scene())).contains("<title>a&lt;b&gt;&amp;&quot;c · Brickless</title>");
    }

    @Test
    void nothingIsLoadedAndOnlyThePagesOwnScriptRuns() throws IOException, GeneralSecurityException {
        String page = page(recording(), SyntheticRun.scene());
        String script = page.substring(page.lastIndexOf("<script>") + 8, page.lastIndexOf("</script>"));
        String hash = Base64.getEncoder()
                .encodeToString(MessageDigest.getInstance("SHA-256").digest(script.getBytes(StandardCharsets.UTF_8)));
        assertThat(page).contains("default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'sha256-"
                + hash + "'");
        assertThat(page.replace("http://www.w3.org/2000/svg", "")).doesNotContain("http:").doesNotContain("https:")
                .doesNotContain("@import");
    }

    @Test
    void signalsAreColumnsOfDifferences() throws IOException {
        ReportRecording recording = new ReportRecording();
        SyntheticRun run = new SyntheticRun(recording);
        run.standing(0);
        run.standing(50_000_000);
        run.standing(120_000_000);
        assertThat(data(page(recording, SyntheticRun.scene())).has("times")).isTrue();
        Column column = new Column(2);
        column.put(3, 1.005);
        column.put(4, Double.NaN);
        column.put(6, -0.5);
        assertThat(column.json()).isEqualTo("{\"places\":2,\"from\":3,\"deltas\":[100,null,null,-150]}");
    }

    @Test
    void tenBusyMinutesStayBelowTenMegabytes() throws IOException {
        ReportRecording recording = new ReportRecording();
        SyntheticRun.busy(recording, 600);
        assertThat(page(recording, SyntheticRun.scene()).length()).isBetween(500_000, 10_000_000);
    }
}
