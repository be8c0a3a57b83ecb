package brickless.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import brickless.browser.Browser;
import java.awt.image.BufferedImage;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.openqa.selenium.Keys;

/** People watch and touch a run in a real browser; the program notices, and its run can be repeated. */
@Tag("browser")
class LiveViewPageTest {
    private static final Duration LONG = Duration.ofHours(10);

    @TempDir Path folder;
    @AutoClose private static Browser browser;
    private PadSource source;
    private LiveView view;

    @BeforeAll
    static void openTheBrowser() {
        browser = new Browser(1280, 720);
    }

    @BeforeEach
    void watchTheProgram() throws Exception {
        source = new PadSource(folder, LONG);
        view = LiveView.open(source, ViewOptions.of(0, Optional.empty(), 1));
    }

    @AfterEach
    void closeTheView() {
        browser.load("about:blank");
        view.close();
    }

    private LivePageInBrowser page() {
        LivePageInBrowser page = new LivePageInBrowser(browser, view);
        page.awaitLine("HELLO");
        return page;
    }

    private static HttpResponse<String> post(String address, String body) throws Exception {
        HttpRequest request = HttpRequest.newBuilder(URI.create(address)).header("Content-Type", "application/json")
                .POST(HttpRequest.BodyPublishers.ofString(body)).build();
        return HttpClient.newHttpClient().send(request, HttpResponse.BodyHandlers.ofString());
    }

    @Test
    void keysOfTheKeyboardReachTheProgramAsLongAsTheyAreHeld() {
        LivePageInBrowser page = page();
        browser.hands().keyDown(Keys.ARROW_DOWN).perform();
        page.awaitLine("Down down");
        browser.await("document.querySelector('.key-down').classList.contains('down')");
        assertThat(page.lines()).doesNotContain("Down up");
        browser.hands().keyUp(Keys.ARROW_DOWN).perform();
        page.awaitLine("Down up");
        browser.hands().sendKeys(Keys.ENTER).perform();
        page.awaitLine("Enter up");
    }

    @Test
    void keysOfTheBrickReachTheProgramAsLongAsTheyAreHeld() {
        LivePageInBrowser page = page();
        page.press(".key-left");
        page.awaitLine("Left down");
        browser.await("document.querySelector('.pad').dataset.led === 'red'");
        browser.await("document.querySelector('[data-part=sound]').textContent === '440 Hz'");
        assertThat(page.lines()).doesNotContain("Left up");
        page.release();
        page.awaitLine("Left up");
    }

    @Test
    void tonesArePlayedUnlessSoundIsOff() {
        LivePageInBrowser page = page();
        browser.run("window.tones = 0; const start = OscillatorNode.prototype.start;"
                + "OscillatorNode.prototype.start = function (...when) { window.tones += this.frequency.value === 440 "
                + "? 1 : 0; start.apply(this, when); };");
        browser.hands().sendKeys("m").sendKeys("m").sendKeys(Keys.ARROW_LEFT).perform();
        browser.await("window.tones === 1");
        browser.hands().sendKeys("m").perform();
        page.awaitLine("Left up");
        browser.hands().sendKeys(Keys.ARROW_LEFT).perform();
        browser.await("document.querySelectorAll('#list-console .row').length === 5");
        assertThat(browser.value("window.tones")).isEqualTo(1L);
    }

    @Test
    void aKeyIsLetGoWhenThePageLosesTheFocus() {
        LivePageInBrowser page = page();
        page.press(".key-enter");
        page.awaitLine("Enter down");
        browser.run("window.dispatchEvent(new Event('blur'))");
        page.awaitLine("Enter up");
        page.release();
    }

    @Test
    void theTouchSensorIsHeldAtItsPortAndOnTheDrawing() {
        LivePageInBrowser page = page();
        page.press(".port.touch");
        page.awaitLine("bumper down");
        page.release();
        page.awaitLine("bumper up");
        page.press(".touch-sensor");
        browser.await("document.querySelector('.port.touch .port-value').textContent === 'pressed'");
        page.release();
        browser.await("document.querySelector('.port.touch .port-value').textContent === 'released'");
    }

    @Test
    void theScreenShowsThePixelsThatTheProgramHas() throws Exception {
        LivePageInBrowser page = page();
        browser.hands().sendKeys(Keys.ARROW_UP).perform();
        page.awaitLine("Up up");
        browser.hands().sendKeys(Keys.ESCAPE).perform();
        page.awaitRun("ended");
        String shown = page.pixels();
        view.close();
        BufferedImage screen = ImageIO.read(source.out().resolve("screen.png").toFile());
        int margin = (screen.getWidth() - 2 * 178) / 2;
        StringBuilder dots = new StringBuilder();
        for (int dot = 0; dot < 178 * 128; dot++) {
            dots.append((screen.getRGB(margin + dot % 178 * 2, margin + dot / 178 * 2) & 0xff) < 0x40 ? '#' : '.');
        }
        assertThat(shown).isEqualTo(dots.toString()).contains("####").endsWith("..#");
    }

    @Test
    void whatTheProgramPrintsIsNeverMarkup() {
        LivePageInBrowser page = page();
        browser.hands().sendKeys(Keys.ARROW_RIGHT).perform();
        page.awaitLine("Right up");
        assertThat(page.lines()).contains(PadSource.NASTY);
        assertThat(browser.value("document.querySelectorAll('img, b').length")).isEqualTo(0L);
    }

    @Test
    void aRobotIsDraggedAndTurned() {
        LivePageInBrowser page = page();
        double[] before = page.pose();
        browser.hands().clickAndHold(page.element("[data-name=robot] .handle-shape polygon")).moveByOffset(40, 20)
                .moveByOffset(40, 20).release().perform();
        double x = before[0] + 80 * page.scale();
        double y = before[1] + 40 * page.scale();
        page.awaitPose("Math.abs(x - %s) < 6 && Math.abs(y - %s) < 6 && Math.abs(heading) < 1".formatted(x, y));
        browser.run("document.querySelector('[data-name=robot]').focus()");
        browser.hands().sendKeys(".").sendKeys(Keys.ARROW_LEFT).perform();
        page.awaitPose("Math.abs(x - %s) < 6 && Math.abs(heading - 5) < 1".formatted(x - 10));
    }

    @Test
    void aBoxIsDraggedAndTakenAway() {
        LivePageInBrowser page = page();
        browser.hands().clickAndHold(page.element("[data-name=tin] .handle-shape polygon")).moveByOffset(-30, 10)
                .release().perform();
        String world = "document.querySelector('.layer.world').shadowRoot.getElementById('tin')";
        String near = "(([x, y]) => Math.abs(x + %s) < 4 && Math.abs(y - %s) < 4)"
                + "((%s.dataset.displacement || '0 0').split(' ').map(Number))";
        browser.await(near.formatted(30 * page.scale(), 10 * page.scale(), world));
        browser.run("document.querySelector('[data-name=tin]').focus()");
        browser.hands().sendKeys(Keys.DELETE).perform();
        browser.await(world + ".style.visibility === 'hidden'");
        assertThat(page.stimuli()).contains("move tin ").contains("remove tin");
    }

    @Test
    void pauseStopsTimeAndStepsGoOnABit() {
        LivePageInBrowser page = page();
        browser.click(".play");
        page.awaitRun("paused");
        double held = page.awaitStates(2);
        assertThat(page.awaitStates(3)).isEqualTo(held);
        assertThat(page.time()).isCloseTo(held, within(0.01));
        browser.click(".step");
        page.awaitTime(held + 0.04);
        assertThat(page.awaitStates(2)).isCloseTo(held + 0.05, within(1e-6));
        browser.keys(" ");
        page.awaitRun("running");
        page.awaitTime(held + 0.5);
    }

    @Test
    void speedIsChangedForAllViewers() {
        LivePageInBrowser page = page();
        try (Browser other = new Browser(390, 844)) {
            LivePageInBrowser second = new LivePageInBrowser(other, view);
            browser.run("const s = document.querySelector('.controls .speed'); s.value = '10'; "
                    + "s.dispatchEvent(new Event('change'));");
            other.await("document.querySelector('.controls .speed').value === '10'");
            browser.await("parseFloat(document.querySelector('.rate').textContent) > 2");
            second.awaitLine("HELLO");
            assertThat(second.time()).isGreaterThan(0);
        }
        double left = page.time();
        page.awaitTime(left + 1);
    }

    @Test
    void restartBeginsAnew() {
        LivePageInBrowser page = page();
        browser.hands().sendKeys(Keys.ENTER).perform();
        page.awaitLine("Enter up");
        browser.await("document.querySelector('.save-count').textContent === '2'");
        browser.click(".restart");
        browser.await("document.body.dataset.session === '2'");
        page.awaitLine("HELLO");
        assertThat(page.lines()).containsExactly("HELLO");
        browser.await("document.querySelector('.save-count').textContent === ''");
        browser.click(".seed");
        browser.await("document.body.dataset.session === '3'");
        assertThat((String) browser.value("document.querySelector('.setting').textContent")).doesNotEndWith("seed 1");
    }

    @Test
    void aSessionWithTouchesIsRepeatedFromItsStimuli() throws Exception {
        LivePageInBrowser page = page();
        page.press(".key-enter");
        page.awaitLine("Enter down");
        page.release();
        page.awaitLine("Enter up");
        browser.hands().clickAndHold(page.element("[data-name=robot] .handle-shape polygon")).moveByOffset(25, 15)
                .moveByOffset(25, -30).release().perform();
        browser.click(".clap");
        browser.run("const b = document.getElementById('battery'); b.value = '6.4'; "
                + "b.dispatchEvent(new Event('input')); b.dispatchEvent(new Event('change'));");
        page.press("[data-remote=TOP_LEFT]");
        page.release();
        browser.hands().sendKeys(Keys.ESCAPE).perform();
        page.awaitRun("ended");
        assertThat(page.status()).isEqualTo("exited");
        String stimuli = page.stimuli();
        assertThat(stimuli).contains("hold key ENTER").contains("move robot ").contains("clap 80dB")
                .contains("battery 6.4V").contains("remote 1 TOP_LEFT");
        assertThat(source.headless(stimuli).traceHash()).isEqualTo(page.hash());
    }

    @Test
    void whenTheProgramHasEndedThePageSaysSo() {
        LivePageInBrowser page = page();
        browser.hands().sendKeys(Keys.BACK_SPACE).perform();
        page.awaitRun("ended");
        assertThat(page.status()).isEqualTo("exited");
        assertThat(page.element(".play").isEnabled()).isFalse();
        double end = page.time();
        page.awaitStates(2);
        assertThat(page.time()).isEqualTo(end);
        browser.hands().sendKeys("R").perform();
        page.awaitRun("running");
    }

    @Test
    void aSecondViewerSeesTheSameAndLeavesWithoutATrace() {
        LivePageInBrowser page = page();
        browser.hands().sendKeys(Keys.ARROW_UP).perform();
        page.awaitLine("Up up");
        try (Browser other = new Browser(1280, 720)) {
            LivePageInBrowser second = new LivePageInBrowser(other, view);
            second.awaitLine("Up up");
            browser.click(".play");
            page.awaitRun("paused");
            second.awaitRun("paused");
            page.awaitStates(2);
            second.awaitStates(2);
            assertThat(second.time()).isEqualTo(page.time());
            assertThat(second.pixels()).isEqualTo(page.pixels());
            assertThat(second.pose()).isEqualTo(page.pose());
            other.click(".play");
            page.awaitRun("running");
        }
        page.awaitTime(page.time() + 0.5);
    }

    @Test
    void thePageFindsAServerThatWasRestarted() throws Exception {
        LivePageInBrowser page = page();
        browser.hands().sendKeys(Keys.ENTER).perform();
        page.awaitLine("Enter up");
        String[] parts = view.address().getPath().split("/");
        int port = view.address().getPort();
        view.close();
        browser.await("document.querySelector('[data-notice=lost]')");
        assertThat(browser.value("document.body.dataset.link")).isEqualTo("lost");
        view = LiveView.open(source, ViewOptions.of(port, Optional.of(parts[1]), 1));
        browser.await("document.body.dataset.link === 'up' && !document.querySelector('[data-notice=lost]')");
        page.awaitLine("HELLO");
        assertThat(page.lines()).doesNotContain("Enter down");
        browser.hands().sendKeys(Keys.ENTER).perform();
        page.awaitLine("Enter up");
    }

    @Test
    void aChangedProgramIsOfferedAndRestarted() throws Exception {
        LivePageInBrowser page = page();
        source.edit("HELLO", "GOOD MORNING");
        browser.await("document.querySelector('[data-notice=changed]')");
        assertThat(page.element("[data-notice=changed]").getText()).contains("Pad.java changed on disk");
        browser.click("[data-notice=changed] .push-button");
        page.awaitLine("GOOD MORNING");
        browser.await("!document.querySelector('[data-notice=changed]')");
    }

    @Test
    void aProgramThatDoesNotCompileIsToldAndTheRunGoesOn() throws Exception {
        LivePageInBrowser page = page();
        source.edit("LCD.clear();", "LCD.cleer();");
        browser.await("document.querySelector('[data-notice=changed]')");
        browser.click(".restart");
        browser.await("document.querySelector('[data-notice=message]')");
        assertThat(page.element("[data-notice=message]").getText()).contains("Pad.java").contains("cleer");
        assertThat(browser.value("document.body.dataset.session")).isEqualTo("1");
        page.awaitTime(page.time() + 0.3);
    }

    @Test
    void whoeverDoesNotKnowTheTokenSeesNothing() throws Exception {
        String wrong = view.address().toString().replaceFirst("/[^/]{16,}/$", "/AAAAAAAAAAAAAAAAAAAAAA/");
        browser.load(wrong);
        assertThat(browser.value("document.querySelector('#arena')")).isNull();
        assertThat(post(wrong + "do", "{\"do\":\"pause\"}").statusCode()).isIn(403, 404);
        assertThat(post(view.address() + "do", "{\"do\":\"pause\"}").statusCode()).isEqualTo(204);
    }

    @Test
    void aRequestThatIsTooLargeIsRefused() throws Exception {
        String padding = " ".repeat(4096);
        assertThat(post(view.address() + "do", "{\"do\":\"pause\"}" + padding).statusCode()).isEqualTo(413);
    }
}
