package brickless.viewer;

import brickless.browser.Browser;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import org.openqa.selenium.WebElement;

/** The live page as a person sees it and touches it. */
final class LivePageInBrowser {
    private static final String ROBOT = "document.querySelector('.layer.robot').shadowRoot"
            + ".querySelector('[data-robot-name]').getAttribute('transform')";
    private static final String LCD = "(() => { const c = document.querySelector('canvas.lcd'); const d = "
            + "c.getContext('2d').getImageData(0, 0, 178, 128).data;"
            + " let text = ''; for (let i = 0; i < d.length; i += 4) { text += d[i] < 100 ? '#' : '.'; } return "
            + "text; })()";
    private static final String LINES =
            "[...document.querySelectorAll('#list-console .row-text')].map((row) => row.textContent)";

    private final Browser browser;

    LivePageInBrowser(Browser browser, LiveView view) {
        this.browser = browser;
        browser.visit(view.address().toString());
    }

    /** Simulated time that the page shows, seconds. */
    double time() {
        String[] parts = ((String) browser.value("document.querySelector('.now').textContent")).split(":");
        return Integer.parseInt(parts[0]) * 60 + Double.parseDouble(parts[1]);
    }

    void awaitTime(double seconds) {
        browser.await("(([m, s]) => m * 60 + Number(s))(document.querySelector('.now').textContent.split(':')) >= "
                + seconds);
    }

    /** Waits until the program has printed a line. */
    void awaitLine(String line) {
        browser.await(LINES + ".includes('" + line + "')");
    }

    @SuppressWarnings("unchecked")
    List<String> lines() {
        return (List<String>) browser.value(LINES);
    }

    /** Waits until the run is {@code running}, {@code paused} or {@code ended}. */
    void awaitRun(String state) {
        browser.await("document.body.dataset.run === '" + state + "'");
    }

    /**
     * Waits until the server has told its state a number of times more, as to a viewer of its own, which then leaves;
     * the run's time in seconds.
     */
    double awaitStates(int count) {
        browser.run("window.told = []; window.ears = new EventSource('events'); "
                + "window.ears.addEventListener('state', (state) => window.told.push(JSON.parse(state.data).t));");
        browser.await("window.told.length >= " + count);
        browser.run("window.ears.close()");
        return ((Number) browser.value("window.told.at(-1)")).doubleValue();
    }

    /** x, y in millimetres and heading in degrees of the drawn robot. */
    double[] pose() {
        String numbers = ((String) browser.value(ROBOT)).replaceAll("[^-0-9. ]", " ").strip();
        return Arrays.stream(numbers.split("\\s+")).mapToDouble(Double::parseDouble).toArray();
    }

    void awaitPose(String condition) {
        browser.await("((x, y, heading) => " + condition + ")(..." + ROBOT + ".match(/-?[0-9.]+/g).map(Number))");
    }

    /** Millimetres in one pixel of the arena. */
    double scale() {
        return ((Number) browser.value("2000 / document.querySelector('.stage').clientWidth")).doubleValue();
    }

    String pixels() {
        return (String) browser.value(LCD);
    }

    WebElement element(String selector) {
        return browser.element(selector);
    }

    /** Holds the left mouse button on an element. */
    void press(String selector) {
        browser.hands().clickAndHold(element(selector)).perform();
    }

    void release() {
        browser.hands().release().perform();
    }

    /** The stimuli file that the page offers. */
    String stimuli() {
        browser.run("window.saved = undefined; fetch(document.querySelector('.save').href).then((answer) => "
                + "answer.text()).then((text) => { window.saved = text; });");
        browser.await("window.saved !== undefined");
        return (String) browser.value("window.saved");
    }

    /** The hash that the page shows of a run that has ended. */
    String hash() {
        String title = (String) browser.value("document.querySelector('[data-part=status]').title");
        return Pattern.compile("[0-9a-f]{64}").matcher(title).results().findFirst().orElseThrow().group();
    }

    String status() {
        return (String) browser.value("document.querySelector('[data-part=status]').textContent");
    }
}
