package brickless.trace;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.browser.Browser;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Reports of made-up runs in a browser of the size of a phone. */
@Tag("browser")
class ReportContentTest {
    private static final String NASTY = "</script><img src=x onerror=\"document.body.dataset.hacked=1\">";
    private static final String HOSTILE_WORLD = "<svg xmlns=\"http://www.w3.org/2000/svg\" "
            + "xmlns:xlink=\"http://www.w3.org/1999/xlink\" viewBox=\"0 0 2000 1000\" "
            + "onload=\"document.body.dataset.hacked=1\"><script>document.body.dataset.hacked=1</script>"
            + "<style>#top{display:none}</style>"
            + "<rect id=\"top\" width=\"2000\" height=\"1000\" fill=\"#eee\" onclick=\"alert(1)\"/>"
            + "<image href=\"file:///etc/hostname\" width=\"9\" height=\"9\"/></svg>";

    @TempDir static Path folder;
    private static Browser browser;

    @BeforeAll
    static void startTheBrowser() {
        browser = new Browser(390, 844);
    }

    @AfterAll
    static void closeTheBrowser() {
        browser.close();
    }

    private static Path page(String name, ReportScene scene, Object... timesAndEvents) throws IOException {
        ReportRecording recording = new ReportRecording();
        SyntheticRun run = new SyntheticRun(recording);
        for (int i = 0; i <= 10; i++) {
            run.standing(i * 1_000_000_000L);
        }
        for (int i = 0; i < timesAndEvents.length; i += 2) {
            run.at(Math.round((double) timesAndEvents[i] * 1e9), (TraceEvent) timesAndEvents[i + 1]);
        }
        Path page = folder.resolve(name + ".html");
        try (OutputStream out = Files.newOutputStream(page)) {
            HtmlReport.write(out, recording, scene, Optional.empty());
        }
        return page;
    }

    private static TraceEvent behaviour(String change, int behaviour) {
        return new TraceEvent.BehaviourEvent(change, 0, behaviour);
    }

    @Test
    void nothingThatTheProgramOrTheWorldSaysRuns() throws IOException {
        browser.open(page("hostile", SyntheticRun.scene(HOSTILE_WORLD), 1.0, new TraceEvent.PrintEvent(NASTY, false),
                2.0, new TraceEvent.ExceptionEvent(NASTY, NASTY), 3.0,
                new TraceEvent.ArbitratorEvent(0, List.of(NASTY))), "#t=5");
        assertThat(browser.value("document.body.dataset.hacked")).isNull();
        assertThat(browser.value("document.querySelector('#list-console .row-text').textContent")).isEqualTo(NASTY);
        assertThat(browser.value("getComputedStyle(document.getElementById('top')).display")).isEqualTo("flex");
        assertThat(browser.value("document.querySelector('.layer.world').shadowRoot"
                + ".querySelectorAll('script, [onclick], [onload], [href]').length")).isEqualTo(0L);
    }

    @Test
    void whoIgnoresSuppressForMoreThanASecondIsShownInRed() throws IOException {
        browser.open(page("stubborn", SyntheticRun.scene(), 0.0,
                new TraceEvent.ArbitratorEvent(0, List.of("a.Stubborn", "a.Polite")), 1.0, behaviour("active", 0), 2.0,
                behaviour("wants", 1), 2.0, behaviour("suppressed", 0), 4.5, behaviour("active", -1), 4.5,
                behaviour("active", 1), 6.0, behaviour("suppressed", 1), 6.9, behaviour("active", -1)), "#t=4");
        assertThat(browser.value("[...document.querySelectorAll('.lane:has(.track-readout.slow)')].map((lane) => "
                + "lane.dataset.behaviour)")).isEqualTo(List.of("Stubborn"));
        assertThat(browser.value("document.querySelector('.timeline-now').textContent")).isEqualTo(
                "Stubborn has been in control for 3.00 s; told to give way 2.00 s ago, does after 2.50 s.");
        assertThat(browser.value("document.querySelector('.timeline-now').className")).isEqualTo("timeline-now slow");
        assertThat((String) browser.value("document.querySelector('#list-events').textContent"))
                .contains("Stubborn ignores suppress(): it took 2.50 s to give way").doesNotContain("Polite ignores");
    }

    @Test
    void aGoalThatWasMissedIsInTheHead() throws IOException {
        String figures =
                "{\"distanceMetres\":1,\"collisions\":0,\"zones\":[],\"traceHash\":\"0123456789\",\"error\":null%s}";
        String outcome = "[document.querySelector('.outcome').textContent, "
                + "document.querySelector('.outcome').className]";
        browser.open(ended(figures.formatted(",\"goal\":\"zone:home\",\"passed\":false")), "");
        assertThat(browser.value(outcome)).isEqualTo(List.of("time-limit, missed zone home", "outcome bad"));
        browser.open(ended(figures.formatted(",\"goal\":\"exit\",\"passed\":false")), "");
        assertThat(browser.value(outcome)).isEqualTo(List.of("time-limit, missed its exit", "outcome bad"));
        browser.open(ended(figures.formatted("")), "");
        assertThat(browser.value(outcome)).isEqualTo(List.of("time-limit", "outcome good"));
    }

    private static Path ended(String summary) throws IOException {
        ReportRecording recording = new ReportRecording();
        SyntheticRun run = new SyntheticRun(recording);
        run.standing(0);
        run.at(1_000_000_000, new TraceEvent.EndEvent("time-limit", -1));
        Path page = folder.resolve("ended.html");
        try (OutputStream out = Files.newOutputStream(page)) {
            HtmlReport.write(out, recording, SyntheticRun.scene(), Optional.of(summary));
        }
        return page;
    }

    @Test
    void nestedBehavioursHaveTheirOwnNames() throws IOException {
        browser.open(page("names", SyntheticRun.scene(), 0.0,
                new TraceEvent.ArbitratorEvent(0, List.of("a.b.Robot$Cruise", "a.Turn", "Robot$1", "Stop"))), "");
        assertThat(browser.value("[...document.querySelectorAll('.lane')].map((lane) => lane.dataset.behaviour)"))
                .isEqualTo(List.of("Stop", "Robot$1", "Turn", "Cruise"));
    }

    @Test
    void keysLedsAndSoundsAreShownWhileTheyLast() throws IOException {
        Path page = page("panel", SyntheticRun.scene(), 1.0, new TraceEvent.KeyEvent("ENTER", true, "auto"), 1.0,
                new TraceEvent.LedEvent(5), 1.0, new TraceEvent.SoundEvent("tone", 440, 500, 50), 1.3,
                new TraceEvent.KeyEvent("ENTER", false, "auto"));
        browser.open(page, "#t=1.1");
        assertThat(browser.value(
                "[document.querySelector('.key.down').dataset.key, document.querySelector('.pad').dataset.led, "
                + "document.querySelector('[data-part=sound]').textContent]"))
                .isEqualTo(List.of("ENTER", "red", "440 Hz"));
        browser.open(page, "#t=1.6");
        assertThat(browser.value(
                "[document.querySelectorAll('.key.down').length, document.querySelector('.pad').dataset.led, "
                + "document.querySelector('[data-part=sound]').textContent]")).isEqualTo(List.of(0L, "red", ""));
        browser.open(page, "#t=1.3");
        assertThat(browser.value("document.querySelector('.pad').dataset.led")).as("flashing, in the dark half")
                .isEqualTo("off");
    }

    @Test
    void aRobotWithoutADrawingIsShownByItsOutline() throws IOException {
        browser.open(page("plain", SyntheticRun.scene()), "");
        assertThat(browser.value(
                "document.querySelector('.layer.robot').shadowRoot.querySelector('polygon').getAttribute('points')"))
                .isEqualTo("-100,-50 100,-50 100,50 -100,50");
    }

    @Test
    void thePageIsNoWiderThanAPhone() throws IOException {
        browser.open(page("phone", SyntheticRun.scene(), 0.0,
                new TraceEvent.ArbitratorEvent(0, List.of("a.QuiteALongNameForABehaviour")),
                1.0, new TraceEvent.PrintEvent("long ".repeat(100), false)), "");
        assertThat(browser.value("document.documentElement.scrollWidth")).isEqualTo(390L);
    }

    @Test
    void tenBusyMinutesOpen() throws IOException {
        ReportRecording recording = new ReportRecording();
        SyntheticRun.busy(recording, 600);
        Path page = folder.resolve("busy.html");
        try (OutputStream out = Files.newOutputStream(page)) {
            HtmlReport.write(out, recording, SyntheticRun.scene(), Optional.empty());
        }
        browser.open(page, "#t=600");
        assertThat(browser.value("document.querySelector('.time').textContent")).isEqualTo("10:00.00 / 10:00");
    }
}
