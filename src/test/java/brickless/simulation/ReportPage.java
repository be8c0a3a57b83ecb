package brickless.simulation;

import brickless.browser.Browser;
import brickless.browser.ShownRobot;
import java.nio.file.Path;
import java.util.List;

/** A report open in a browser, read the way a person does: from what it shows. */
final class ReportPage {
    private final Browser browser;
    private final ShownRobot robot;

    ReportPage(Browser browser, Path page, String fragment) {
        this.browser = browser;
        robot = new ShownRobot(browser);
        browser.open(page, fragment);
    }

    /** Time of the replay in seconds. */
    double time() {
        return Double.parseDouble((String) browser.value("document.querySelector('.scrub').value"));
    }

    /** x, y in millimetres and heading in degrees of the drawn robot. */
    double[] pose() {
        return robot.pose();
    }

    /** The screen row by row, {@code #} for a dark dot. */
    String pixels() {
        return robot.pixels();
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
