package brickless.simulation;

import brickless.browser.Browser;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;

/** A report open in a browser, read the way a person does: from what it shows. */
final class ReportPage {
    private static final String ROBOT = "document.querySelector('.layer.robot').shadowRoot"
            + ".querySelector('[data-robot-name]').getAttribute('transform')";
    private static final String PIXELS = "(() => { const c = document.querySelector('canvas.lcd'); const d = "
            + "c.getContext('2d').getImageData(0, 0, 178, 128).data;"
            + " let text = ''; for (let i = 0; i < d.length; i += 4) { text += d[i] < 100 ? '#' : '.'; } return "
            + "text; })()";

    private final Browser browser;

    ReportPage(Browser browser, Path page, String fragment) {
        this.browser = browser;
        browser.open(page, fragment);
    }

    /** Time of the replay in seconds. */
    double time() {
        return Double.parseDouble((String) browser.value("document.querySelector('.scrub').value"));
    }

    /** x, y in millimetres and heading in degrees of the drawn robot. */
    double[] pose() {
        String numbers = ((String) browser.value(ROBOT)).replaceAll("[^-0-9. ]", " ").strip();
        return Arrays.stream(numbers.split("\\s+")).mapToDouble(Double::parseDouble).toArray();
    }

    /** The screen row by row, {@code #} for a dark dot. */
    String pixels() {
        return (String) browser.value(PIXELS);
    }

    /** The behaviours shown as being in control. */
    @SuppressWarnings("unchecked")
    List<String> activeBehaviours() {
        return (List<String>) browser.value(
                "[...document.querySelectorAll('.lane[data-active=true]')].map((lane) => lane.dataset.behaviour)");
    }

    void scrubTo(double seconds) {
        browser.run("const s = document.querySelector('.scrub'); s.value = " + seconds
                + "; s.dispatchEvent(new Event('input'));");
    }
}
