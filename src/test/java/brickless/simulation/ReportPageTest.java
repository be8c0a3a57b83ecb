package brickless.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import brickless.browser.Browser;
import brickless.program.Program;
import brickless.program.ProgramFinder;
import brickless.trace.BodySample;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.openqa.selenium.Keys;

/** The report of a real run in a real browser agrees with the run's trace, however one gets to a moment. */
@Tag("browser")
class ReportPageTest {
    private static final int SECONDS = 16;

    @TempDir static Path folder;
    private static Browser browser;
    private static TraceTruth truth;

    @BeforeAll
    static void runTheExplorer() throws Exception {
        Path home = Path.of(System.getProperty("brickless.home"));
        SimulationSettings settings = SimulationSettings.builder(new Library(home).world("sim/worlds/pen.svg"))
                .limit(Duration.ofSeconds(SECONDS)).out(Optional.of(folder)).build();
        try (Program program = new ProgramFinder(home, List.of(), Optional.empty())
                .find("sim/programs/explorer/Explorer.java");
                Run run = new Simulation(settings).start(program)) {
            run.toEnd();
        }
        truth = new TraceTruth(folder);
        browser = new Browser(1280, 720);
    }

    @AfterAll
    static void closeTheBrowser() {
        if (browser != null) {
            browser.close();
        }
    }

    private static ReportPage open(String fragment) {
        return new ReportPage(browser, folder.resolve("report.html"), fragment);
    }

    private static void assertAgrees(ReportPage page, double seconds) {
        assertThat(page.time()).as("time").isCloseTo(seconds, within(1e-6));
        assertThat(page.pose()).as("pose at %s s", seconds)
                .usingElementComparator((a, b) -> Math.abs(a - b) < 0.02 ? 0 : Double.compare(a, b))
                .containsExactly(truth.pose(seconds));
        assertThat(page.pixels()).as("screen at %s s", seconds).isEqualTo(truth.pixels(seconds));
        assertThat(page.activeBehaviours()).as("active behaviour at %s s", seconds)
                .isEqualTo(truth.activeBehaviours(seconds));
    }

    @Test
    void threeMomentsAgreeWithTheTrace() {
        ReportPage page = open("");
        for (double seconds : new double[] {12.9, 3.5, 9}) {
            page.scrubTo(seconds);
            assertAgrees(page, seconds);
        }
        assertThat(truth.activeBehaviours(9)).as("a moment worth comparing").isNotEqualTo(truth.activeBehaviours(3));
        assertThat(truth.pixels(9)).contains("#");
    }

    @Test
    void anAddressWithATimeOpensThere() {
        assertAgrees(open("#t=9.95"), 9.95);
    }

    @Test
    void keysGoToMoments() {
        ReportPage page = open("");
        browser.keys(Keys.END);
        assertAgrees(page, SECONDS);
        browser.keys(Keys.HOME);
        assertAgrees(page, 0);
        browser.keys(Keys.ARROW_RIGHT, Keys.ARROW_RIGHT, Keys.ARROW_RIGHT);
        browser.shifted(Keys.ARROW_LEFT);
        assertAgrees(page, 2.95);
    }

    @Test
    void playingMovesOnAndPausingStops() {
        ReportPage page = open("#t=2");
        browser.click(".play");
        browser.await("document.querySelector('.scrub').value > 2.6");
        browser.keys(" ");
        double stopped = page.time();
        browser.await("document.querySelector('.play').getAttribute('aria-label') === 'Play'");
        assertThat(page.time()).isEqualTo(stopped).isBetween(2.6, 15.0);
        assertThat(page.pose()[0]).isNotCloseTo(truth.pose(2)[0], within(1.0));
        assertThat(page.pixels()).isEqualTo(truth.pixels(stopped));
    }

    @Test
    void whoeverPlaysToTheEndStaysThere() {
        ReportPage page = open("#t=15.5");
        browser.run("const s = document.querySelector('.speed'); s.value = '4'; s.dispatchEvent(new Event('change'));");
        browser.click(".play");
        browser.await("Number(document.querySelector('.scrub').value) === " + SECONDS);
        browser.await("document.querySelector('.play').getAttribute('aria-label') === 'Play'");
        assertAgrees(page, SECONDS);
    }

    @Test
    void aPushedBoxIsDrawnWhereItWasPushed() {
        BodySample box = truth.trace().samples.get(truth.trace().samples.size() - 1).bodies().get(0);
        open("#t=" + SECONDS);
        String shown = (String) browser.value(
                "document.querySelector('.layer.world').shadowRoot.getElementById('" + box.id()
                + "').getAttribute('data-displacement')");
        assertThat(Arrays.stream(shown.split(" ")).map(Double::valueOf))
                .usingElementComparator((a, b) -> Math.abs(a - b) < 0.01 ? 0 : Double.compare(a, b))
                .containsExactly(box.displacement().x() * 1000, box.displacement().y() * 1000,
                        Math.toDegrees(box.displacement().headingRadians()));
    }

    @Test
    void anUntouchedBoxIsDrawnAtItsPlace() {
        open("#t=0");
        assertThat(browser.value(
                "document.querySelector('.layer.world').shadowRoot.querySelector('[data-displacement]')")).isNull();
    }

    @Test
    void anEventThatIsClickedIsGoneTo() {
        ReportPage page = open("");
        double seconds = ((Number) browser.value(
                "Number(document.querySelectorAll('#list-events .row')[5].dataset.time)")).doubleValue();
        browser.click("#list-events .row:nth-child(6)");
        assertThat(page.time()).isEqualTo(seconds);
        browser.run("document.getElementById('list-events').focus()");
        browser.value("document.getElementById('list-events')"
                + ".dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowDown', bubbles: true}))");
        assertThat(page.time()).isGreaterThanOrEqualTo(seconds);
        assertThat(browser.value("document.querySelectorAll('#list-events [aria-selected=true]').length"))
                .isEqualTo(1L);
    }

    @Test
    void withoutTheBrowsersDecompressionThePageUnpacksItself() {
        browser.open(folder.resolve("report.html"), "#own-inflate");
        ReportPage page = new ReportPage(browser, folder.resolve("report.html"), "#own-inflate&t=9");
        assertAgrees(page, 9);
    }

    @Test
    void madeAgainFromTheTraceTheReportShowsTheSame() throws Exception {
        Path copy = folder.resolve("copy");
        Files.createDirectories(copy);
        for (String name : List.of("trace.jsonl", "world.svg", "robot.svg", "summary.json")) {
            Files.copy(folder.resolve(name), copy.resolve(name));
        }
        Path again = FinishedRun.open(copy).report();
        assertThat(again).hasSameBinaryContentAs(folder.resolve("report.html"));
    }
}
